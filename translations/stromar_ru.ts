<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru">
<context>
    <name>ClampingBox</name>
    <message>
        <source>The maximum is %1</source>
        <translation>Максимум: %1</translation>
    </message>
    <message>
        <source>The minimum is %1</source>
        <translation>Минимум: %1</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Новое</translation>
    </message>
    <message>
        <source>Start with a plain tree</source>
        <translation>Начать с простого дерева</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Открыть…</translation>
    </message>
    <message>
        <source>Open a .tree file</source>
        <translation>Открыть файл .tree</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Сохранить</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Сохранить дерево</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Сохранить &amp;как…</translation>
    </message>
    <message>
        <source>Save the tree in another file</source>
        <translation>Сохранить дерево в другой файл</translation>
    </message>
    <message>
        <source>Save as &amp;Preset…</source>
        <translation>Сохранить как &amp;заготовку…</translation>
    </message>
    <message>
        <source>Keep the tree among your own presets</source>
        <translation>Добавить дерево к своим заготовкам</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Экспорт…</translation>
    </message>
    <message>
        <source>Write the tree for another program</source>
        <translation>Записать дерево для другой программы</translation>
    </message>
    <message>
        <source>Save P&amp;icture…</source>
        <translation>Сохранить &amp;картинку…</translation>
    </message>
    <message>
        <source>A picture of the tree, or the frames of a turntable</source>
        <translation>Картинка дерева или кадры вращения</translation>
    </message>
    <message>
        <source>Load &amp;Bark Texture…</source>
        <translation>Загрузить текстуру ко&amp;ры…</translation>
    </message>
    <message>
        <source>Choose the picture on the stems</source>
        <translation>Выбрать картинку для ствола и ветвей</translation>
    </message>
    <message>
        <source>Load &amp;Leaf Texture…</source>
        <translation>Загрузить текстуру &amp;листа…</translation>
    </message>
    <message>
        <source>Choose the picture on the leaves</source>
        <translation>Выбрать картинку для листьев</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Выход</translation>
    </message>
    <message>
        <source>Leave Stromar</source>
        <translation>Выйти из Stromar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Отменить последнее изменение</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Вернуть</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Повторить изменение</translation>
    </message>
    <message>
        <source>&amp;Find Parameter</source>
        <translation>&amp;Найти параметр</translation>
    </message>
    <message>
        <source>Look for a parameter by its name</source>
        <translation>Искать параметр по имени</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Настройки…</translation>
    </message>
    <message>
        <source>Theme, language, mouse, units</source>
        <translation>Тема, язык, мышь, единицы</translation>
    </message>
    <message>
        <source>&amp;Another Seed</source>
        <translation>&amp;Другое зерно</translation>
    </message>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Другое дерево того же вида</translation>
    </message>
    <message>
        <source>&amp;Generate</source>
        <translation>&amp;Построить заново</translation>
    </message>
    <message>
        <source>Build the tree again from scratch</source>
        <translation>Построить дерево с самого начала</translation>
    </message>
    <message>
        <source>&amp;Full Model</source>
        <translation>Полная &amp;модель</translation>
    </message>
    <message>
        <source>Show the full model now</source>
        <translation>Показать полную модель сейчас</translation>
    </message>
    <message>
        <source>&amp;Stop Growing</source>
        <translation>О&amp;становить рост</translation>
    </message>
    <message>
        <source>Give up the tree that is growing, and let go of what is selected</source>
        <translation>Бросить растущее дерево и снять выделение</translation>
    </message>
    <message>
        <source>&amp;Recentre</source>
        <translation>По &amp;центру</translation>
    </message>
    <message>
        <source>See the whole tree from the front</source>
        <translation>Всё дерево спереди</translation>
    </message>
    <message>
        <source>&amp;Frame the Tree</source>
        <translation>Всё &amp;дерево</translation>
    </message>
    <message>
        <source>See the whole tree from where you are</source>
        <translation>Всё дерево с того места, где вы находитесь</translation>
    </message>
    <message>
        <source>From the Fr&amp;ont</source>
        <translation>С&amp;переди</translation>
    </message>
    <message>
        <source>Look along the Y axis</source>
        <translation>Вид вдоль оси Y</translation>
    </message>
    <message>
        <source>Look along the X axis</source>
        <translation>Вид вдоль оси X</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>С&amp;верху</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Вид вниз</translation>
    </message>
    <message>
        <source>Ort&amp;hographic</source>
        <translation>&amp;Ортогонально</translation>
    </message>
    <message>
        <source>Without perspective</source>
        <translation>Без перспективы</translation>
    </message>
    <message>
        <source>Turn &amp;Freely</source>
        <translation>Вращать с&amp;вободно</translation>
    </message>
    <message>
        <source>Roll the tree in all directions instead of keeping it upright</source>
        <translation>Вращать дерево во все стороны, а не только стоя</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Каркас</translation>
    </message>
    <message>
        <source>Show the wireframe</source>
        <translation>Показать каркас</translation>
    </message>
    <message>
        <source>Show the wireframe on the shaded tree</source>
        <translation>Показать каркас на затенённом дереве</translation>
    </message>
    <message>
        <source>&amp;Bare</source>
        <translation>&amp;Без листьев</translation>
    </message>
    <message>
        <source>Hide the leaves</source>
        <translation>Скрыть листья</translation>
    </message>
    <message>
        <source>&amp;Grid and Person</source>
        <translation>&amp;Сетка и человек</translation>
    </message>
    <message>
        <source>Show a grid of metres and a person beside the tree</source>
        <translation>Показать метровую сетку и человека рядом с деревом</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>Ст&amp;атистика</translation>
    </message>
    <message>
        <source>Show sizes and counts in the picture</source>
        <translation>Показать размеры и количества в картинке</translation>
    </message>
    <message>
        <source>S&amp;ky</source>
        <translation>&amp;Небо</translation>
    </message>
    <message>
        <source>Sky and ground behind the tree</source>
        <translation>Небо и земля за деревом</translation>
    </message>
    <message>
        <source>&amp;Light Grey</source>
        <translation>&amp;Светло-серый</translation>
    </message>
    <message>
        <source>A light, plain backdrop</source>
        <translation>Светлый однотонный фон</translation>
    </message>
    <message>
        <source>&amp;Dark Grey</source>
        <translation>&amp;Тёмно-серый</translation>
    </message>
    <message>
        <source>A dark, plain backdrop</source>
        <translation>Тёмный однотонный фон</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Сбросить расположение</translation>
    </message>
    <message>
        <source>Put all docks back to where they were at first</source>
        <translation>Вернуть все панели на исходные места</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Руководство</translation>
    </message>
    <message>
        <source>Read how Stromar works</source>
        <translation>Прочитать, как работает Stromar</translation>
    </message>
    <message>
        <source>Mouse and &amp;Keys</source>
        <translation>Мышь и &amp;клавиши</translation>
    </message>
    <message>
        <source>How to move about, and all shortcuts</source>
        <translation>Как двигаться и все сочетания клавиш</translation>
    </message>
    <message>
        <source>&amp;About Stromar</source>
        <translation>&amp;О программе Stromar</translation>
    </message>
    <message>
        <source>Version and origin</source>
        <translation>Версия и происхождение</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;Tree</source>
        <translation>&amp;Дерево</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Окно</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;Lit</source>
        <translation>&amp;Освещённо</translation>
    </message>
    <message>
        <source>The tree in the light</source>
        <translation>Дерево в свете</translation>
    </message>
    <message>
        <source>&amp;Material Alone</source>
        <translation>Только &amp;материал</translation>
    </message>
    <message>
        <source>The pictures without light</source>
        <translation>Картинки без света</translation>
    </message>
    <message>
        <source>O&amp;cclusion Alone</source>
        <translation>Только &amp;затенение</translation>
    </message>
    <message>
        <source>How much of the sky each place sees</source>
        <translation>Сколько неба видно из каждой точки</translation>
    </message>
    <message>
        <source>&amp;Normals Alone</source>
        <translation>Только &amp;нормали</translation>
    </message>
    <message>
        <source>Where each place faces, as a colour</source>
        <translation>Куда обращена каждая точка, цветом</translation>
    </message>
    <message>
        <source>Wireframe &amp;over the Tree</source>
        <translation>Каркас по&amp;верх дерева</translation>
    </message>
    <message>
        <source>&amp;Record…</source>
        <translation>&amp;Записать…</translation>
    </message>
    <message>
        <source>Pictures or a video of the tree as it grows or sways</source>
        <translation>Картинки или видео растущего или качающегося дерева</translation>
    </message>
    <message>
        <source>&amp;Play Growth</source>
        <translation>&amp;Проиграть рост</translation>
    </message>
    <message>
        <source>Let the tree grow from its first day</source>
        <translation>Дерево растёт с первого дня</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>&amp;Ветер</translation>
    </message>
    <message>
        <source>Let the tree sway in the wind</source>
        <translation>Дерево качается на ветру</translation>
    </message>
    <message>
        <source>F&amp;ell…</source>
        <translation>С&amp;рубить…</translation>
    </message>
    <message>
        <source>Cut the tree and let it fall; the timeline runs over its fall</source>
        <translation>Срубить дерево; шкала времени идёт по его падению</translation>
    </message>
    <message>
        <source>&amp;Picture or Panorama…</source>
        <translation>&amp;Изображение или панорама…</translation>
    </message>
    <message>
        <source>Tint What Is &amp;Edited</source>
        <translation>Подкрашивать р&amp;едактируемое</translation>
    </message>
    <message>
        <source>Keep the tint of what the value in hand changes; else it only flashes</source>
        <translation>Оставлять подкрашенным то, что меняет выбранное значение; иначе оно лишь вспыхивает</translation>
    </message>
    <message>
        <source>A photograph, or an HDRI panorama that lights the tree</source>
        <translation>Фотография или панорама HDRI, которая освещает дерево</translation>
    </message>
    <message>
        <source>Level of Detail &amp;0</source>
        <translation>Уровень детализации &amp;0</translation>
    </message>
    <message>
        <source>The full model, for near views</source>
        <translation>Полная модель, для вида вблизи</translation>
    </message>
    <message>
        <source>Level of Detail &amp;1</source>
        <translation>Уровень детализации &amp;1</translation>
    </message>
    <message>
        <source>The full model as it is seen from some way off</source>
        <translation>Полная модель, как она видна с некоторого расстояния</translation>
    </message>
    <message>
        <source>Level of Detail &amp;2</source>
        <translation>Уровень детализации &amp;2</translation>
    </message>
    <message>
        <source>The full model from afar, with cards of whole twigs</source>
        <translation>Полная модель издалека, с карточками целых веточек</translation>
    </message>
    <message>
        <source>Level of Detail &amp;3</source>
        <translation>Уровень детализации &amp;3</translation>
    </message>
    <message>
        <source>The coarsest full model, for trees on the horizon</source>
        <translation>Самая грубая полная модель, для деревьев на горизонте</translation>
    </message>
    <message>
        <source>At Its Distance</source>
        <translation>На его расстоянии</translation>
    </message>
    <message>
        <source>Move to where a program would begin to show this level of detail</source>
        <translation>Отойти туда, откуда программа начала бы показывать этот уровень детализации</translation>
    </message>
    <message>
        <source>From the Back</source>
        <translation>Сзади</translation>
    </message>
    <message>
        <source>From the Right</source>
        <translation>Справа</translation>
    </message>
    <message>
        <source>From the Left</source>
        <translation>Слева</translation>
    </message>
    <message>
        <source>From Below</source>
        <translation>Снизу</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Взгляд вверх</translation>
    </message>
    <message>
        <source>Save Camera…</source>
        <translation>Сохранить камеру…</translation>
    </message>
    <message>
        <source>Keep this view of the tree under a name</source>
        <translation>Сохраняет этот вид дерева под именем</translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation>Линейка</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure</source>
        <translation>Протяните от одной точки до другой, чтобы измерить расстояние</translation>
    </message>
    <message>
        <source>Reference Picture…</source>
        <translation>Эталонное изображение…</translation>
    </message>
    <message>
        <source>A picture of a real tree, in its true size, behind the one in the window</source>
        <translation>Снимок настоящего дерева в натуральную величину позади дерева в окне</translation>
    </message>
    <message>
        <source>Keep as “Before”</source>
        <translation>Запомнить как «до»</translation>
    </message>
    <message>
        <source>Keep the tree as it is now, to compare with what you make of it</source>
        <translation>Запоминает дерево таким, какое оно сейчас, для сравнения с тем, что из него получится</translation>
    </message>
    <message>
        <source>Show “Before”</source>
        <translation>Показать «до»</translation>
    </message>
    <message>
        <source>The tree as it was kept, until this is switched off or a value changes</source>
        <translation>Запомненное дерево, пока это не выключено или не изменено значение</translation>
    </message>
    <message>
        <source>One Tree</source>
        <translation>Одно дерево</translation>
    </message>
    <message>
        <source>The tree alone</source>
        <translation>Только само дерево</translation>
    </message>
    <message>
        <source>Nine Seeds Side by Side</source>
        <translation>Девять зёрен рядом</translation>
    </message>
    <message>
        <source>The tree among eight others of its kind</source>
        <translation>Дерево среди восьми других того же вида</translation>
    </message>
    <message>
        <source>Five Ages Side by Side</source>
        <translation>Пять возрастов рядом</translation>
    </message>
    <message>
        <source>The tree from its youth to its full age</source>
        <translation>Дерево от молодости до полного возраста</translation>
    </message>
    <message>
        <source>Four Seasons Side by Side</source>
        <translation>Четыре времени года рядом</translation>
    </message>
    <message>
        <source>The tree in winter, spring, summer and autumn</source>
        <translation>Дерево зимой, весной, летом и осенью</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Добро пожаловать</translation>
    </message>
    <message>
        <source>The ways to begin, as at the first start</source>
        <translation>Способы начать, как при первом запуске</translation>
    </message>
    <message>
        <source>Look along the negative Y axis</source>
        <translation>Взгляд в обратном направлении оси Y</translation>
    </message>
    <message>
        <source>Look along the negative X axis</source>
        <translation>Взгляд в обратном направлении оси X</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>&amp;Импорт…</translation>
    </message>
    <message>
        <source>Read a tree of Arbaro, Sapling or tree-gen</source>
        <translation>Прочитать дерево программы Arbaro, Sapling или tree-gen</translation>
    </message>
    <message>
        <source>Simple Model</source>
        <translation>Простая модель</translation>
    </message>
    <message>
        <source>The model that follows a slider, instead of the full one</source>
        <translation>Модель, которая следует за ползунком, вместо полной</translation>
    </message>
    <message>
        <source>Wipe between “Before” and Now</source>
        <translation>Граница между «до» и «сейчас»</translation>
    </message>
    <message>
        <source>Both trees with a line between them, which can be dragged</source>
        <translation>Оба дерева и между ними линия, которую можно двигать</translation>
    </message>
    <message>
        <source>Levels of Detail Side by Side</source>
        <translation>Уровни детализации рядом</translation>
    </message>
    <message>
        <source>The four levels of detail and the simple model, with their triangles</source>
        <translation>Четыре уровня детализации и простая модель с числом треугольников</translation>
    </message>
    <message>
        <source>Look From</source>
        <translation>Направление взгляда</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Фон</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Затенение</translation>
    </message>
    <message>
        <source>Level of Detail</source>
        <translation>Уровень детализации</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Сравнение</translation>
    </message>
    <message>
        <source>Side by Side</source>
        <translation>Рядом</translation>
    </message>
</context>
<context>
    <name>Counts</name>
    <message>
        <source>1 stem</source>
        <translation>1 ветвь</translation>
    </message>
    <message>
        <source>%1 stems</source>
        <translation>%1 ветвей</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Простая модель</translation>
    </message>
    <message>
        <source>Full model</source>
        <translation>Полная модель</translation>
    </message>
    <message>
        <source>Level of detail %1</source>
        <translation>Уровень детализации %1</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>Cannot use the values</source>
        <translation>Значения использовать нельзя</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Вставить %1</translation>
    </message>
    <message>
        <source>Save Values</source>
        <translation>Сохранить значения</translation>
    </message>
    <message>
        <source>Name of these values</source>
        <translation>Имя этих значений</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>&amp;Copy Values</source>
        <translation>&amp;Копировать значения</translation>
    </message>
    <message>
        <source>&amp;Paste Values</source>
        <translation>&amp;Вставить значения</translation>
    </message>
    <message>
        <source>&amp;Save Values…</source>
        <translation>&amp;Сохранить значения…</translation>
    </message>
    <message>
        <source>There is no value for %1 among these lines.</source>
        <translation>Среди этих строк нет значений для «%1».</translation>
    </message>
    <message>
        <source>There are values called “%1” already. Replace them?</source>
        <translation>Значения с именем «%1» уже есть. Заменить их?</translation>
    </message>
</context>
<context>
    <name>stromar</name>
    <message>
        <source>Full model</source>
        <translation>Полная модель</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Простая модель</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Нет</translation>
    </message>
    <message>
        <source>In one file</source>
        <translation>В одном файле</translation>
    </message>
    <message>
        <source>A file for each</source>
        <translation>Каждый в своём файле</translation>
    </message>
    <message>
        <source>As usual in the format</source>
        <translation>Как принято в формате</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Inside the file</source>
        <translation>Внутри файла</translation>
    </message>
    <message>
        <source>Copies beside it</source>
        <translation>Копии рядом</translation>
    </message>
    <message>
        <source>Where they are</source>
        <translation>Где лежат</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
    <message>
        <source>Which model: the full one, or the simple one of the preview.</source>
        <translation>Какая модель: полная или простая, как при просмотре.</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Уровень детализации</translation>
    </message>
    <message>
        <source>All levels of detail</source>
        <translation>Все уровни детализации</translation>
    </message>
    <message>
        <source>All four levels of detail: inside one file, or a file for each, named after it.</source>
        <translation>Все четыре уровня: внутри одного файла или каждый в своём, названном по нему.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Масштаб</translation>
    </message>
    <message>
        <source>The model&apos;s metres are multiplied by this: 100 writes centimetres.</source>
        <translation>Метры модели умножаются на это число: 100 запишет сантиметры.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Ось вверх</translation>
    </message>
    <message>
        <source>Which axis points up. &apos;format&apos; takes what programs expect of the format.</source>
        <translation>Какая ось смотрит вверх. «format» берёт то, чего программы ждут от формата.</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Текстуры</translation>
    </message>
    <message>
        <source>Pictures inside the file, as copies beside it, or where they lie now. &apos;format&apos; takes what is usual.</source>
        <translation>Картинки внутри файла, копиями рядом или там, где лежат сейчас. «format» берёт обычное.</translation>
    </message>
    <message>
        <source>%1 cannot hold levels of detail; choose a file for each</source>
        <translation>%1 не хранит уровни детализации; выберите отдельные файлы</translation>
    </message>
    <message>
        <source>levels of detail belong to the full model; the simple model has none</source>
        <translation>уровни детализации есть у полной модели; у простой их нет</translation>
    </message>
    <message>
        <source>in %1 files y is always up</source>
        <translation>в файлах %1 вверх всегда смотрит y</translation>
    </message>
    <message>
        <source>in %1 files z is always up</source>
        <translation>в файлах %1 вверх всегда смотрит z</translation>
    </message>
    <message>
        <source>%1 cannot hold pictures; choose copies</source>
        <translation>%1 не хранит картинки; выберите копии</translation>
    </message>
    <message>
        <source>glTF, one file</source>
        <translation>glTF, один файл</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>glTF, with its buffer and pictures beside it</source>
        <translation>glTF, данные и картинки рядом</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>COLLADA</source>
        <translation>COLLADA</translation>
    </message>
    <message>
        <source>Stanford PLY, binary</source>
        <translation>Stanford PLY, двоичный</translation>
    </message>
    <message>
        <source>STL, binary</source>
        <translation>STL, двоичный</translation>
    </message>
    <message>
        <source>3D Studio</source>
        <translation>3D Studio</translation>
    </message>
    <message>
        <source>LightWave object</source>
        <translation>Объект LightWave</translation>
    </message>
    <message>
        <source>POV-Ray scene</source>
        <translation>Сцена POV-Ray</translation>
    </message>
    <message>
        <source>OpenSceneGraph binary</source>
        <translation>OpenSceneGraph, двоичный</translation>
    </message>
    <message>
        <source>OpenSceneGraph text</source>
        <translation>OpenSceneGraph, текстовый</translation>
    </message>
    <message>
        <source>OpenSceneGraph, old text form</source>
        <translation>OpenSceneGraph, старый текстовый вид</translation>
    </message>
    <message>
        <source>Width and widest place</source>
        <translation>Ширина и самое широкое место</translation>
    </message>
    <message>
        <source>Curve above</source>
        <translation>Кривая сверху</translation>
    </message>
    <message>
        <source>Curve below</source>
        <translation>Кривая снизу</translation>
    </message>
    <message>
        <source>Bare trunk</source>
        <translation>Голый ствол</translation>
    </message>
    <message>
        <source>Length of the branches</source>
        <translation>Длина ветвей</translation>
    </message>
    <message>
        <source>Stromar: left turns, right zooms, middle moves</source>
        <translation>Stromar: левая вращает, правая приближает, средняя двигает</translation>
    </message>
    <message>
        <source>Blender: middle button with Shift and Ctrl</source>
        <translation>Blender: средняя кнопка с Shift и Ctrl</translation>
    </message>
    <message>
        <source>Maya: all buttons with Alt</source>
        <translation>Maya: все кнопки с Alt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>левой</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>средней</translation>
    </message>
    <message>
        <source>right</source>
        <translation>правой</translation>
    </message>
    <message>
        <source>%1 drag</source>
        <translation>Тянуть %1 кнопкой</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Вращение</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Сдвиг</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Ближе и дальше</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Как в системе</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Метры</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Футы</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Тема</translation>
    </message>
    <message>
        <source>Light or dark windows.</source>
        <translation>Светлые или тёмные окна.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Язык</translation>
    </message>
    <message>
        <source>The language of menus, parameters and help.</source>
        <translation>Язык меню, параметров и справки.</translation>
    </message>
    <message>
        <source>Mouse in the picture</source>
        <translation>Мышь в картинке</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom. The wheel always zooms.</source>
        <translation>Какие кнопки вращают, двигают и приближают. Колесо приближает всегда.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Длины в</translation>
    </message>
    <message>
        <source>The unit of lengths in the window. Files are always in metres.</source>
        <translation>Единица длины в окне. В файлах всегда метры.</translation>
    </message>
    <message>
        <source>Full model after</source>
        <translation>Полная модель через</translation>
    </message>
    <message>
        <source>How long the hand rests before the full model follows the simple one.</source>
        <translation>Сколько рука должна отдыхать, прежде чем за простой моделью придёт полная.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> мс</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Потоки</translation>
    </message>
    <message>
        <source>How many processors grow the tree; 0 takes all.</source>
        <translation>Сколько процессоров растят дерево; 0 — все.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>Автосохранение каждые</translation>
    </message>
    <message>
        <source>How often changes are kept aside against a crash; 0 never.</source>
        <translation>Как часто изменения откладываются на случай сбоя; 0 — никогда.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> с</translation>
    </message>
    <message>
        <source>conical</source>
        <translation>коническая</translation>
    </message>
    <message>
        <source>spherical</source>
        <translation>шаровидная</translation>
    </message>
    <message>
        <source>hemispherical</source>
        <translation>полушаровидная</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>цилиндрическая</translation>
    </message>
    <message>
        <source>tapered-cylindrical</source>
        <translation>сужающийся-цилиндр</translation>
    </message>
    <message>
        <source>flame</source>
        <translation>пламя</translation>
    </message>
    <message>
        <source>inverse-conical</source>
        <translation>обратный-конус</translation>
    </message>
    <message>
        <source>tend-flame</source>
        <translation>мягкое-пламя</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>оболочка</translation>
    </message>
    <message>
        <source>oval</source>
        <translation>овал</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>треугольник</translation>
    </message>
    <message>
        <source>three-lobe-oak</source>
        <translation>дубовый-трёхлопастный</translation>
    </message>
    <message>
        <source>three-lobe-maple</source>
        <translation>кленовый-трёхлопастный</translation>
    </message>
    <message>
        <source>five-lobe-maple</source>
        <translation>кленовый-пятилопастный</translation>
    </message>
    <message>
        <source>three-leaflets</source>
        <translation>три-листочка</translation>
    </message>
    <message>
        <source>square</source>
        <translation>квадрат</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>иглы</translation>
    </message>
    <message>
        <source>card</source>
        <translation>карточка</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>контур</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выкл</translation>
    </message>
    <message>
        <source>on</source>
        <translation>вкл</translation>
    </message>
    <message>
        <source>The tree is a bare trunk: Levels of stems is 1.</source>
        <translation>Дерево — голый ствол: число уровней равно 1.</translation>
    </message>
    <message>
        <source>It acts on stems of level 2 and deeper, and there are none.</source>
        <translation>Действует на ветви уровня 2 и глубже, а их нет.</translation>
    </message>
    <message>
        <source>The trunk has no lobes.</source>
        <translation>У ствола нет лопастей.</translation>
    </message>
    <message>
        <source>The trunk has no lobes, or they have no depth.</source>
        <translation>У ствола нет лопастей, или у них нет глубины.</translation>
    </message>
    <message>
        <source>The trunk has only one segment, so there is no joint to split at.</source>
        <translation>У ствола один сегмент, делиться негде.</translation>
    </message>
    <message>
        <source>These stems never split.</source>
        <translation>Эти ветви никогда не делятся.</translation>
    </message>
    <message>
        <source>Nothing in this tree splits.</source>
        <translation>В этом дереве ничего не делится.</translation>
    </message>
    <message>
        <source>A card shows what its texture shows: set Form to outline.</source>
        <translation>Карточка показывает свою текстуру: задайте вид «контур».</translation>
    </message>
    <message>
        <source>Nothing is pruned: Strength is 0.</source>
        <translation>Ничего не обрезается: сила равна 0.</translation>
    </message>
    <message>
        <source>Nothing is pruned, and the crown shape is not the envelope.</source>
        <translation>Ничего не обрезается, и форма кроны — не оболочка.</translation>
    </message>
    <message>
        <source>Crown shape</source>
        <translation>Форма кроны</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Крона</translation>
    </message>
    <message>
        <source>The outline of the crown: how long the branches are from its bottom to its top. &apos;envelope&apos; takes the outline of the pruning tab.</source>
        <translation>Очертание кроны: как длинны ветви снизу доверху. «оболочка» берёт очертание с вкладки обрезки.</translation>
    </message>
    <message>
        <source>The part of the tree&apos;s height, from the ground, that bears no branches.</source>
        <translation>Часть высоты дерева от земли, на которой нет ветвей.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Высота</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <source>The height of the tree.</source>
        <translation>Высота дерева.</translation>
    </message>
    <message>
        <source>Height variation</source>
        <translation>Разброс высоты</translation>
    </message>
    <message>
        <source>How much taller or smaller a tree of another seed may be.</source>
        <translation>Насколько выше или ниже может быть дерево с другим зерном.</translation>
    </message>
    <message>
        <source>Z scale</source>
        <translation>Масштаб Z</translation>
    </message>
    <message>
        <source>Printed in the paper&apos;s tables but used by none of its formulas. Kept in files, without effect.</source>
        <translation>Есть в таблицах статьи, но ни одна её формула его не использует. Хранится в файлах, не действует.</translation>
    </message>
    <message>
        <source>Z scale variation</source>
        <translation>Разброс масштаба Z</translation>
    </message>
    <message>
        <source>Levels of stems</source>
        <translation>Уровни ветвления</translation>
    </message>
    <message>
        <source>1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level.</source>
        <translation>1 растит голый ствол, 2 добавляет ветви, 3 — ветви на ветвях. Листья сидят на последнем уровне.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Толщина</translation>
    </message>
    <message>
        <source>The radius of the trunk divided by its length.</source>
        <translation>Радиус ствола, делённый на его длину.</translation>
    </message>
    <message>
        <source>Thinning</source>
        <translation>Утоньшение</translation>
    </message>
    <message>
        <source>How much thinner than its parent a shorter branch is. Higher values make finer branches.</source>
        <translation>Насколько ветвь короче — настолько она тоньше родителя. Большие значения дают более тонкие ветви.</translation>
    </message>
    <message>
        <source>No stem is drawn thinner than this, so that fine twigs stay visible.</source>
        <translation>Ничто не рисуется тоньше этого, чтобы тонкие веточки оставались видны.</translation>
    </message>
    <message>
        <source>Attraction up</source>
        <translation>Стремление вверх</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Рост</translation>
    </message>
    <message>
        <source>How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang.</source>
        <translation>Как сильно ветви уровня 2 и глубже тянутся вверх к свету. При отрицательных значениях они свисают.</translation>
    </message>
    <message>
        <source>Halve splitting</source>
        <translation>Делить пополам</translation>
    </message>
    <message>
        <source>On: a stem that has split, and its clones, split half as often from then on.</source>
        <translation>Вкл: разделившаяся ветвь и её клоны дальше делятся вдвое реже.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Зерно</translation>
    </message>
    <message>
        <source>Every seed gives another tree of the same kind. The same seed always grows the same tree.</source>
        <translation>Каждое зерно даёт другое дерево того же вида. Одно и то же зерно всегда растит одно и то же дерево.</translation>
    </message>
    <message>
        <source>Radius factor</source>
        <translation>Множитель радиуса</translation>
    </message>
    <message>
        <source>Makes the trunk thicker or thinner than Thickness says, and the branches with it.</source>
        <translation>Делает ствол толще или тоньше, чем задаёт толщина, и ветви вместе с ним.</translation>
    </message>
    <message>
        <source>Radius factor variation</source>
        <translation>Разброс множителя радиуса</translation>
    </message>
    <message>
        <source>How much the radius factor differs from seed to seed.</source>
        <translation>Насколько множитель радиуса меняется от зерна к зерну.</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Расширение комля</translation>
    </message>
    <message>
        <source>How much the trunk widens at the ground. 1 makes it twice as thick there.</source>
        <translation>Насколько ствол расширяется у земли. 1 делает его там вдвое толще.</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Лопасти</translation>
    </message>
    <message>
        <source>The number of bulges around the trunk. Odd numbers look natural, even ones symmetric.</source>
        <translation>Число выступов вокруг ствола. Нечётные выглядят естественно, чётные — симметрично.</translation>
    </message>
    <message>
        <source>Lobe depth</source>
        <translation>Глубина лопастей</translation>
    </message>
    <message>
        <source>How far the bulges stand out, as a part of the radius.</source>
        <translation>Насколько выступы выдаются, как доля радиуса.</translation>
    </message>
    <message>
        <source>Lobes fade</source>
        <translation>Затухание лопастей</translation>
    </message>
    <message>
        <source>1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk.</source>
        <translation>1 — лопасти кончаются чуть выше земли, 0 — идут по всему стволу.</translation>
    </message>
    <message>
        <source>Splits at the base</source>
        <translation>Деления у основания</translation>
    </message>
    <message>
        <source>Splitting</source>
        <translation>Деление</translation>
    </message>
    <message>
        <source>So many more trunks grow out of the end of the trunk&apos;s first segment.</source>
        <translation>Столько ещё стволов вырастает из конца первого сегмента ствола.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Число</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Размещение</translation>
    </message>
    <message>
        <source>The most branches of this level that one parent can bear.</source>
        <translation>Наибольшее число ветвей этого уровня на одном родителе.</translation>
    </message>
    <message>
        <source>Spread along segments</source>
        <translation>Разброс по сегментам</translation>
    </message>
    <message>
        <source>1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls.</source>
        <translation>1 размещает ветви равномерно, 0 собирает их у нижнего конца каждого сегмента родителя, мутовками.</translation>
    </message>
    <message>
        <source>Place variation</source>
        <translation>Разброс места</translation>
    </message>
    <message>
        <source>How far each branch is moved along its parent, as a part of the spacing.</source>
        <translation>Насколько каждая ветвь сдвинута вдоль родителя, как доля промежутка.</translation>
    </message>
    <message>
        <source>Down angle</source>
        <translation>Угол отклонения</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Направление</translation>
    </message>
    <message>
        <source>The angle between a branch and its parent. 90 stands off at a right angle.</source>
        <translation>Угол между ветвью и её родителем. 90 — под прямым углом.</translation>
    </message>
    <message>
        <source>Down angle variation</source>
        <translation>Разброс угла отклонения</translation>
    </message>
    <message>
        <source>How much the down angle differs from branch to branch. Negative values are not random: they grade the angle along the parent, more at its base, less at its tip.</source>
        <translation>Насколько угол меняется от ветви к ветви. Отрицательные значения не случайны: угол меняется вдоль родителя, больше у основания, меньше у вершины.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Поворот</translation>
    </message>
    <message>
        <source>The turn about the parent from one branch to the next. Negative values put the branches on alternate sides.</source>
        <translation>Поворот вокруг родителя от одной ветви к следующей. Отрицательные значения ставят ветви попеременно по сторонам.</translation>
    </message>
    <message>
        <source>Rotation variation</source>
        <translation>Разброс поворота</translation>
    </message>
    <message>
        <source>How much the rotation differs from branch to branch.</source>
        <translation>Насколько поворот меняется от ветви к ветви.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длина</translation>
    </message>
    <message>
        <source>The length as a part of the parent&apos;s length; for the trunk, of the tree&apos;s height.</source>
        <translation>Длина как доля длины родителя; для ствола — высоты дерева.</translation>
    </message>
    <message>
        <source>Length variation</source>
        <translation>Разброс длины</translation>
    </message>
    <message>
        <source>How much the length differs from stem to stem.</source>
        <translation>Насколько длина меняется от ветви к ветви.</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Сбег</translation>
    </message>
    <message>
        <source>The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres.</source>
        <translation>Форма древесины: 0 цилиндр, 1 конус, 2 цилиндр с круглым концом, 3 цепочка шаров.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Сегменты</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Кривизна</translation>
    </message>
    <message>
        <source>The number of segments a stem consists of. More segments bend and split more finely.</source>
        <translation>Из скольких сегментов состоит ветвь. Чем больше, тем плавнее изгиб и деление.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Изгиб</translation>
    </message>
    <message>
        <source>How much the stem bends from base to tip. Positive values bend down, negative ones up.</source>
        <translation>Насколько ветвь изгибается от основания к вершине. Положительные значения — вниз, отрицательные — вверх.</translation>
    </message>
    <message>
        <source>Curve back</source>
        <translation>Обратный изгиб</translation>
    </message>
    <message>
        <source>Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems.</source>
        <translation>Если не 0, нижняя половина гнётся по изгибу, верхняя — по этому значению: S-образные ветви.</translation>
    </message>
    <message>
        <source>Curve variation</source>
        <translation>Разброс изгиба</translation>
    </message>
    <message>
        <source>Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle.</source>
        <translation>Случайный изгиб, распределённый по сегментам. Отрицательные значения свивают ветвь в спираль с этим углом.</translation>
    </message>
    <message>
        <source>Splits per segment</source>
        <translation>Делений на сегмент</translation>
    </message>
    <message>
        <source>How many clones split off at the end of each segment, on average. 1 forks at every one.</source>
        <translation>Сколько клонов отделяется в конце каждого сегмента, в среднем. 1 — развилка на каждом.</translation>
    </message>
    <message>
        <source>Split angle</source>
        <translation>Угол деления</translation>
    </message>
    <message>
        <source>How far each part leans away from the vertical after a split. Towards its tip it turns back again.</source>
        <translation>Насколько каждая часть отклоняется от вертикали после деления. К вершине она возвращается.</translation>
    </message>
    <message>
        <source>Split angle variation</source>
        <translation>Разброс угла деления</translation>
    </message>
    <message>
        <source>How much the split angle differs from fork to fork.</source>
        <translation>Насколько угол деления меняется от развилки к развилке.</translation>
    </message>
    <message>
        <source>The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip.</source>
        <translation>Наибольшее число листьев на ветви последнего уровня. Отрицательные значения собирают их веером на конце.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Плотность</translation>
    </message>
    <message>
        <source>Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays.</source>
        <translation>Меньше 1 — листьев меньше, но крупнее, больше 1 — больше и мельче: площадь листвы сохраняется.</translation>
    </message>
    <message>
        <source>Turn to the light</source>
        <translation>Поворот к свету</translation>
    </message>
    <message>
        <source>How far the leaves turn outwards and up to the light.</source>
        <translation>Насколько листья поворачиваются наружу и вверх к свету.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Форма</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Пластинка</translation>
    </message>
    <message>
        <source>The kind of leaf: its outline where the form is &apos;outline&apos;. A card shows what its texture shows.</source>
        <translation>Вид листа: его контур, если вид «контур». Карточка показывает свою текстуру.</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Вид</translation>
    </message>
    <message>
        <source>A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency.</source>
        <translation>Карточка — прямоугольник с текстурой листа. Контур вырезан по форме и не требует прозрачности.</translation>
    </message>
    <message>
        <source>The length of a leaf.</source>
        <translation>Длина листа.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>The width of a leaf as a part of its length.</source>
        <translation>Ширина листа как доля его длины.</translation>
    </message>
    <message>
        <source>Stalk</source>
        <translation>Черешок</translation>
    </message>
    <message>
        <source>The length of the stalk between stem and blade, as a part of the leaf&apos;s length.</source>
        <translation>Длина черешка между ветвью и пластинкой как доля длины листа.</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Складка</translation>
    </message>
    <message>
        <source>How far each half of a leaf is folded up along its midrib.</source>
        <translation>Насколько каждая половина листа согнута вверх вдоль средней жилки.</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Округление</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Затенение</translation>
    </message>
    <message>
        <source>Shades the leaves as if they were the surface of one round crown: softer light on dense crowns.</source>
        <translation>Затеняет листья так, будто они поверхность одной круглой кроны: мягче свет на густых кронах.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Сила</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Оболочка</translation>
    </message>
    <message>
        <source>0 leaves the branches alone, 1 shortens them until they stay inside the envelope.</source>
        <translation>0 не трогает ветви, 1 укорачивает их, пока они не останутся внутри оболочки.</translation>
    </message>
    <message>
        <source>The radius of the envelope at its widest place, as a part of the tree&apos;s height.</source>
        <translation>Радиус оболочки в самом широком месте как доля высоты дерева.</translation>
    </message>
    <message>
        <source>Widest place</source>
        <translation>Самое широкое место</translation>
    </message>
    <message>
        <source>Where the envelope is widest, from 0 at its bottom to 1 at its top.</source>
        <translation>Где оболочка шире всего, от 0 внизу до 1 вверху.</translation>
    </message>
    <message>
        <source>The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Оболочка ниже самого широкого места: меньше 1 выпуклая, 1 прямая, больше 1 вогнутая.</translation>
    </message>
    <message>
        <source>The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Оболочка выше самого широкого места: меньше 1 выпуклая, 1 прямая, больше 1 вогнутая.</translation>
    </message>
    <message>
        <source>Bark repeats around</source>
        <translation>Повторов коры вокруг</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Кора</translation>
    </message>
    <message>
        <source>How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam.</source>
        <translation>Сколько раз картинка коры обходит ствол; ветви следуют за ним. Целые числа не оставляют шва.</translation>
    </message>
    <message>
        <source>Bark repeats along</source>
        <translation>Повторов коры вдоль</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Порода</translation>
    </message>
    <message>
        <source>About</source>
        <translation>О дереве</translation>
    </message>
    <message>
        <source>The name of the kind of tree.</source>
        <translation>Название породы дерева.</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Автор</translation>
    </message>
    <message>
        <source>Who made the file.</source>
        <translation>Кто создал файл.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Описание</translation>
    </message>
    <message>
        <source>What the tree is like.</source>
        <translation>Каково дерево.</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Любимые зёрна</translation>
    </message>
    <message>
        <source>Seeds worth finding again, separated by blanks.</source>
        <translation>Зёрна, которые стоит найти снова, через пробел.</translation>
    </message>
    <message>
        <source>Bark texture</source>
        <translation>Текстура коры</translation>
    </message>
    <message>
        <source>Leaf texture</source>
        <translation>Текстура листа</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Листья</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: see Levels of stems.</source>
        <translation>У дерева нет ветвей этого уровня: см. «Уровни ветвления».</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: a Number of branches is 0.</source>
        <translation>У дерева нет ветвей этого уровня: одно из чисел ветвей равно 0.</translation>
    </message>
    <message>
        <source>This level would place the leaves, and the tree has none.</source>
        <translation>Этот уровень разместил бы листья, а их у дерева нет.</translation>
    </message>
    <message>
        <source>Leaves grow on branches, and the tree is a bare trunk.</source>
        <translation>Листья растут на ветвях, а дерево — голый ствол.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0.</source>
        <translation>У дерева нет листьев: их число равно 0.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Дерево</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Ствол</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Ветви</translation>
    </message>
    <message>
        <source>Pruning</source>
        <translation>Обрезка</translation>
    </message>
    <message>
        <source>The picture on the stems; its path starts at the file&apos;s folder. A recipe as bark:furrowed seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Картинка на древесине; путь начинается в папке файла. Рецепт вроде bark:furrowed seed=3 рисуется. Пусто — встроенная.</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>бороздчатая</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>пластинчатая</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>гладкая</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>берёза</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>ива</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>вишня</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>пальма</translation>
    </message>
    <message>
        <source>Another bark of the same kind.</source>
        <translation>Другая кора того же вида.</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Гребни</translation>
    </message>
    <message>
        <source>How many ridges or plates stand side by side in the picture.</source>
        <translation>Сколько гребней или пластин стоит в картинке рядом.</translation>
    </message>
    <message>
        <source>Length of ridges</source>
        <translation>Длина гребней</translation>
    </message>
    <message>
        <source>How many times longer than wide they are.</source>
        <translation>Во сколько раз они длиннее своей ширины.</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Трещины</translation>
    </message>
    <message>
        <source>How wide the furrows between them are, as a part of a ridge.</source>
        <translation>Как широки борозды между ними, как доля гребня.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Глубина</translation>
    </message>
    <message>
        <source>How deep the relief is.</source>
        <translation>Насколько глубок рельеф.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Зернистость</translation>
    </message>
    <message>
        <source>How rough the surface is in detail.</source>
        <translation>Насколько шероховата поверхность вблизи.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Извилистость</translation>
    </message>
    <message>
        <source>How crooked ridges and rings run.</source>
        <translation>Насколько криво идут гребни и кольца.</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Кольца</translation>
    </message>
    <message>
        <source>How many bands run around the stem in the picture.</source>
        <translation>Сколько полос в картинке огибает ствол.</translation>
    </message>
    <message>
        <source>Spots</source>
        <translation>Пятна</translation>
    </message>
    <message>
        <source>How many pores or eyes there are.</source>
        <translation>Сколько пор или глазков.</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Светлый цвет</translation>
    </message>
    <message>
        <source>The colour of what stands out.</source>
        <translation>Цвет выступающего.</translation>
    </message>
    <message>
        <source>Dark colour</source>
        <translation>Тёмный цвет</translation>
    </message>
    <message>
        <source>The colour of what lies deep.</source>
        <translation>Цвет глубокого.</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Время суток</translation>
    </message>
    <message>
        <source>Where the sun stands: low and red in the morning and in the evening.</source>
        <translation>Где стоит солнце: утром и вечером низко и красно.</translation>
    </message>
    <message>
        <source>Sun direction</source>
        <translation>Направление солнца</translation>
    </message>
    <message>
        <source>Turns the sun&apos;s way about the tree.</source>
        <translation>Поворачивает путь солнца вокруг дерева.</translation>
    </message>
    <message>
        <source>lance</source>
        <translation>ланцетный</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>сердцевидный</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>перистый</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>пальчатый</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>веер</translation>
    </message>
    <message>
        <source>Only cards have several planes: set Form to card.</source>
        <translation>Несколько плоскостей бывает только у карточек: выберите форму «карточка».</translation>
    </message>
    <message>
        <source>The tree has only one trunk.</source>
        <translation>У дерева только один ствол.</translation>
    </message>
    <message>
        <source>The tree has no leaves, blossoms or fruits.</source>
        <translation>У дерева нет ни листьев, ни цветов, ни плодов.</translation>
    </message>
    <message>
        <source>The tree has no blossoms: their Number is 0.</source>
        <translation>У дерева нет цветов: их Число равно 0.</translation>
    </message>
    <message>
        <source>The tree has no fruits: their Number is 0.</source>
        <translation>У дерева нет плодов: их Число равно 0.</translation>
    </message>
    <message>
        <source>Month</source>
        <translation>Месяц</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Время года</translation>
    </message>
    <message>
        <source>The time of the year: 0 is New Year, 4.5 spring, 7 summer, 10 autumn. Leaves, their colour, blossoms and fruits follow.</source>
        <translation>Время года: 0 — Новый год, 4,5 — весна, 7 — лето, 10 — осень. За ним следуют листья, их цвет, цветы и плоды.</translation>
    </message>
    <message>
        <source>Evergreen</source>
        <translation>Вечнозелёное</translation>
    </message>
    <message>
        <source>On: the leaves stay, and stay green, through the winter.</source>
        <translation>Включено: листья остаются на зиму и остаются зелёными.</translation>
    </message>
    <message>
        <source>Trunks</source>
        <translation>Стволы</translation>
    </message>
    <message>
        <source>Several trunks</source>
        <translation>Несколько стволов</translation>
    </message>
    <message>
        <source>How many trunks rise from one base: shrubs, clumps of bamboo.</source>
        <translation>Сколько стволов растёт из одного основания: кусты, заросли бамбука.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Разброс</translation>
    </message>
    <message>
        <source>How far from the middle the outermost trunk stands.</source>
        <translation>Как далеко от середины стоит крайний ствол.</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Наклон</translation>
    </message>
    <message>
        <source>How far the outermost trunk leans outwards; the others less.</source>
        <translation>Насколько крайний ствол наклонён наружу; остальные меньше.</translation>
    </message>
    <message>
        <source>At one place</source>
        <translation>В одном месте</translation>
    </message>
    <message>
        <source>How many branches leave their parent at the same height, all around it: 2 are opposite, more a whorl.</source>
        <translation>Сколько ветвей отходит на одной высоте вокруг: 2 — супротивные, больше — мутовка.</translation>
    </message>
    <message>
        <source>How many leaves leave a stem at the same place: 1 are alternate, 2 opposite, more a whorl.</source>
        <translation>Сколько листьев отходит в одном месте: 1 — очередные, 2 — супротивные, больше — мутовка.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Плоскости</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one leaf: 2 or 3 for tufts and twigs of needles.</source>
        <translation>Сколько карточек, повёрнутых вокруг длины, составляют лист: 2 или 3 для пучков и веточек хвои.</translation>
    </message>
    <message>
        <source>Blossoms</source>
        <translation>Цветы</translation>
    </message>
    <message>
        <source>The most blossoms that a stem of the last level bears. They stand where leaves could.</source>
        <translation>Наибольшее число цветов на стебле последнего уровня. Они стоят там, где могли бы быть листья.</translation>
    </message>
    <message>
        <source>The length and width of a blossom, or of the cluster that its picture shows.</source>
        <translation>Длина и ширина цветка или соцветия на его картинке.</translation>
    </message>
    <message>
        <source>When the tree is in full blossom; it begins and ends most of a month before and after.</source>
        <translation>Когда дерево в полном цвету; начинается и кончается почти за месяц до и после.</translation>
    </message>
    <message>
        <source>Fruits</source>
        <translation>Плоды</translation>
    </message>
    <message>
        <source>The most fruits that a stem of the last level bears.</source>
        <translation>Наибольшее число плодов на стебле последнего уровня.</translation>
    </message>
    <message>
        <source>The length of a ripe fruit.</source>
        <translation>Длина спелого плода.</translation>
    </message>
    <message>
        <source>The width of a fruit as a part of its length: small for cones and pods.</source>
        <translation>Ширина плода как доля длины: малая для шишек и стручков.</translation>
    </message>
    <message>
        <source>The length of the stalk that a fruit hangs on, as a part of its own length.</source>
        <translation>Длина плодоножки как доля длины плода.</translation>
    </message>
    <message>
        <source>When the fruits are ripe. They grow in the two months before and fall in the month after.</source>
        <translation>Когда плоды спелые. Они растут два месяца до этого и опадают за месяц после.</translation>
    </message>
    <message>
        <source>The picture on the leaves, transparent outside the blade. A recipe as leaf:oak seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Картинка на листьях, прозрачная вне пластинки. Рецепт вида leaf:oak seed=3 рисуется. Пустое значит встроенную.</translation>
    </message>
    <message>
        <source>Blossom texture</source>
        <translation>Текстура цветов</translation>
    </message>
    <message>
        <source>Blossoms and fruits</source>
        <translation>Цветы и плоды</translation>
    </message>
    <message>
        <source>The picture on the blossoms. Empty draws leaf:blossom.</source>
        <translation>Картинка на цветах. Пустое рисует leaf:blossom.</translation>
    </message>
    <message>
        <source>Fruit texture</source>
        <translation>Текстура плодов</translation>
    </message>
    <message>
        <source>The skin of the fruits. Empty draws a red one.</source>
        <translation>Кожица плодов. Пустое рисует красную.</translation>
    </message>
    <message>
        <source>Blossoms and fruits grow on branches, and the tree is a bare trunk.</source>
        <translation>Цветы и плоды растут на ветвях, а дерево — голый ствол.</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Цветение</translation>
    </message>
    <message>
        <source>beech</source>
        <translation>бук</translation>
    </message>
    <message>
        <source>oak</source>
        <translation>дуб</translation>
    </message>
    <message>
        <source>aspen</source>
        <translation>осина</translation>
    </message>
    <message>
        <source>lime</source>
        <translation>липа</translation>
    </message>
    <message>
        <source>apple</source>
        <translation>яблоня</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>олива</translation>
    </message>
    <message>
        <source>bamboo</source>
        <translation>бамбук</translation>
    </message>
    <message>
        <source>maple</source>
        <translation>клён</translation>
    </message>
    <message>
        <source>japanese-maple</source>
        <translation>японский клён</translation>
    </message>
    <message>
        <source>ash</source>
        <translation>ясень</translation>
    </message>
    <message>
        <source>acacia</source>
        <translation>акация</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>пальмовый лист</translation>
    </message>
    <message>
        <source>chestnut</source>
        <translation>каштан</translation>
    </message>
    <message>
        <source>pine</source>
        <translation>сосна</translation>
    </message>
    <message>
        <source>spruce</source>
        <translation>ель</translation>
    </message>
    <message>
        <source>larch</source>
        <translation>лиственница</translation>
    </message>
    <message>
        <source>cedar</source>
        <translation>кедр</translation>
    </message>
    <message>
        <source>cypress</source>
        <translation>кипарис</translation>
    </message>
    <message>
        <source>flower</source>
        <translation>цветок</translation>
    </message>
    <message>
        <source>blossom</source>
        <translation>соцветие</translation>
    </message>
    <message>
        <source>Another leaf of the same kind.</source>
        <translation>Другой лист того же вида.</translation>
    </message>
    <message>
        <source>The width of the picture as a part of its length. Give Width of the tree&apos;s leaves the same value.</source>
        <translation>Ширина картинки как доля длины. Дайте Ширине листьев дерева то же значение.</translation>
    </message>
    <message>
        <source>The part of the length that is stalk.</source>
        <translation>Доля длины, которую занимает черешок.</translation>
    </message>
    <message>
        <source>Where a blade is widest, from 0 at its foot to 1 at its tip.</source>
        <translation>Где пластинка шире всего, от 0 у основания до 1 на кончике.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Основание</translation>
    </message>
    <message>
        <source>Below 1 the blade begins round, above 1 like a wedge.</source>
        <translation>Меньше 1 — начинается округло, больше 1 — клином.</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Кончик</translation>
    </message>
    <message>
        <source>Below 1 the blade ends round, above 1 in a drawn-out point.</source>
        <translation>Меньше 1 — заканчивается округло, больше 1 — вытянутым остриём.</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Сердце</translation>
    </message>
    <message>
        <source>How far the blade reaches back beside its stalk.</source>
        <translation>Как далеко пластинка заходит назад вдоль черешка.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Зубцы</translation>
    </message>
    <message>
        <source>How many teeth each half of a blade has.</source>
        <translation>Сколько зубцов у каждой половины пластинки.</translation>
    </message>
    <message>
        <source>Depth of teeth</source>
        <translation>Глубина зубцов</translation>
    </message>
    <message>
        <source>How deep they are cut, as a part of the half&apos;s width.</source>
        <translation>Насколько глубоко вырезаны, как доля ширины половины.</translation>
    </message>
    <message>
        <source>Depth of lobes</source>
        <translation>Глубина лопастей</translation>
    </message>
    <message>
        <source>How deep they are cut. Of leaflets and needles: how wide they are.</source>
        <translation>Насколько глубоко вырезаны. У листочков и игл: насколько широки.</translation>
    </message>
    <message>
        <source>Slant</source>
        <translation>Скос</translation>
    </message>
    <message>
        <source>How far teeth and lobes lean towards the tip.</source>
        <translation>Насколько зубцы и лопасти наклонены к кончику.</translation>
    </message>
    <message>
        <source>Leaflets</source>
        <translation>Листочки</translation>
    </message>
    <message>
        <source>Pairs of leaflets, leaflets of a hand, needles or petals.</source>
        <translation>Пары листочков, листочки ладони, иглы или лепестки.</translation>
    </message>
    <message>
        <source>How far lobes, leaflets or needles stand off, in degrees.</source>
        <translation>Насколько отстоят лопасти, листочки или иглы, в градусах.</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Жилки</translation>
    </message>
    <message>
        <source>How many veins leave the midrib on each side.</source>
        <translation>Сколько жилок отходит от главной с каждой стороны.</translation>
    </message>
    <message>
        <source>Blemishes</source>
        <translation>Изъяны</translation>
    </message>
    <message>
        <source>How many spots and worn places there are.</source>
        <translation>Сколько пятен и изношенных мест.</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Блеск</translation>
    </message>
    <message>
        <source>How much the upper side shines.</source>
        <translation>Насколько блестит верхняя сторона.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Цвет</translation>
    </message>
    <message>
        <source>The colour in summer.</source>
        <translation>Цвет летом.</translation>
    </message>
    <message>
        <source>Veins&apos; colour</source>
        <translation>Цвет жилок</translation>
    </message>
    <message>
        <source>The colour of veins and stalks.</source>
        <translation>Цвет жилок и черешков.</translation>
    </message>
    <message>
        <source>Autumn colour</source>
        <translation>Осенний цвет</translation>
    </message>
    <message>
        <source>The colour when the green has gone.</source>
        <translation>Цвет, когда зелень ушла.</translation>
    </message>
    <message>
        <source>0.5 is the middle of January, 7 the height of summer, 10.5 late autumn.</source>
        <translation>0,5 — середина января, 7 — разгар лета, 10,5 — поздняя осень.</translation>
    </message>
    <message>
        <source>candle</source>
        <translation>свеча</translation>
    </message>
    <message>
        <source>The trunk has no roots.</source>
        <translation>У ствола нет корней.</translation>
    </message>
    <message>
        <source>Roots</source>
        <translation>Корни</translation>
    </message>
    <message>
        <source>The number of ridges that run from the trunk into the ground. High ones are buttresses.</source>
        <translation>Сколько гребней уходит от ствола в землю. Высокие — это досковидные корни.</translation>
    </message>
    <message>
        <source>Reach of roots</source>
        <translation>Вылет корней</translation>
    </message>
    <message>
        <source>How far the roots reach out of the trunk on the ground, in radii of the trunk.</source>
        <translation>Насколько корни выступают из ствола у земли, в радиусах ствола.</translation>
    </message>
    <message>
        <source>Height of roots</source>
        <translation>Высота корней</translation>
    </message>
    <message>
        <source>Where the roots leave the trunk, as a part of its length.</source>
        <translation>Где корни отходят от ствола, как доля его длины.</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Прямостояние</translation>
    </message>
    <message>
        <source>1 sets blossoms upright like candles, -1 lets them hang like catkins, 0 lets them stand like leaves.</source>
        <translation>1 ставит цветы прямо, как свечи, -1 даёт им висеть, как серёжкам, 0 — стоять, как листьям.</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one blossom: 2 or 3 for candles and catkins.</source>
        <translation>Сколько карточек, повёрнутых вокруг длины, составляют цветок: 2 или 3 для свечей и серёжек.</translation>
    </message>
    <message>
        <source>Min radius</source>
        <translation>Мин. радиус</translation>
    </message>
    <message>
        <source>Weber and Penn</source>
        <translation>Вебер и Пенн</translation>
    </message>
    <message>
        <source>Botanical values by level: trunk, branches, twigs. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</source>
        <translation>Ботанические параметры по уровням: ствол, ветви, веточки. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</translation>
    </message>
    <message>
        <source>Memory for a tree</source>
        <translation>Память на дерево</translation>
    </message>
    <message>
        <source>The most that a tree may take while it is made; 0 is half of what is free.</source>
        <translation>Сколько памяти дерево может занять при построении; 0 — половина свободной.</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> ГБ</translation>
    </message>
    <message>
        <source>Grammar</source>
        <translation>Грамматика</translation>
    </message>
    <message>
        <source>Nothing bends: the strength of the tropism is 0.</source>
        <translation>Ничто не изгибается: сила тропизма равна 0.</translation>
    </message>
    <message>
        <source>Every turn of the grammar has a number.</source>
        <translation>У каждого поворота в грамматике есть число.</translation>
    </message>
    <message>
        <source>It places the leaves of stems: their Number is 0. Leaves that the grammar writes stand where it says.</source>
        <translation>Размещает листья на ветвях: их Число равно 0. Листья, которые пишет грамматика, стоят там, где она указывает.</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Правила</translation>
    </message>
    <message>
        <source>The rules that the tree grows by: values, an axiom, and productions that rewrite every module of the word at once.</source>
        <translation>Правила, по которым растёт дерево: значения, аксиома и продукции, переписывающие сразу все модули слова.</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Шаги вывода</translation>
    </message>
    <message>
        <source>How often the word is rewritten.</source>
        <translation>Сколько раз переписывается слово.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Единица длины</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Черепаха</translation>
    </message>
    <message>
        <source>How long F(1) is.</source>
        <translation>Длина F(1).</translation>
    </message>
    <message>
        <source>Unit of width</source>
        <translation>Единица ширины</translation>
    </message>
    <message>
        <source>How thick wood of the width !(1) is: a diameter.</source>
        <translation>Толщина древесины ширины !(1): диаметр.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Угол</translation>
    </message>
    <message>
        <source>How far + - &amp; ^ \ / turn where they have no number.</source>
        <translation>На сколько поворачивают + - &amp; ^ \ / без числа.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Тропизм</translation>
    </message>
    <message>
        <source>How far every F bends towards the tropism&apos;s direction when it stands square to it, in radians.</source>
        <translation>На сколько каждый F изгибается к направлению тропизма, если перпендикулярен ему, в радианах.</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Направление X</translation>
    </message>
    <message>
        <source>Where stems bend to: gravity points down, light up, wind aside.</source>
        <translation>Куда изгибаются ветви: тяжесть тянет вниз, свет вверх, ветер вбок.</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Направление Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Направление Z</translation>
    </message>
    <message>
        <source>Where stems bend to: -1 is down.</source>
        <translation>Куда изгибаются ветви: -1 — вниз.</translation>
    </message>
    <message>
        <source>How many leaves a stem without branches bears, besides those that the grammar writes as ~L.</source>
        <translation>Сколько листьев несёт ветвь без побегов, кроме тех, что грамматика пишет как ~L.</translation>
    </message>
    <message>
        <source>The angle between these leaves and their stem.</source>
        <translation>Угол между этими листьями и их ветвью.</translation>
    </message>
    <message>
        <source>The turn about the stem from one of these leaves to the next.</source>
        <translation>Поворот вокруг ветви от одного из этих листьев к следующему.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0, and the grammar writes no ~L.</source>
        <translation>У дерева нет листьев: их Число равно 0, и грамматика не пишет ~L.</translation>
    </message>
    <message>
        <source>L-system</source>
        <translation>L-система</translation>
    </message>
    <message>
        <source>A grammar rewrites a word, and a turtle draws it. The Algorithmic Beauty of Plants, chapters 1 and 2.</source>
        <translation>Грамматика переписывает слово, а черепаха его рисует. The Algorithmic Beauty of Plants, главы 1 и 2.</translation>
    </message>
    <message>
        <source>L-systems (*.l *.lsys)</source>
        <translation>L-системы (*.l *.lsys)</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Пряди</translation>
    </message>
    <message>
        <source>Turns aside (Gravelius order)</source>
        <translation>Повороты в сторону (порядок по Гравелиусу)</translation>
    </message>
    <message>
        <source>Splits below (Weibull order)</source>
        <translation>Разделений ниже (порядок по Вейбуллу)</translation>
    </message>
    <message>
        <source>height, m</source>
        <translation>высота, м</translation>
    </message>
    <message>
        <source>from the root, m</source>
        <translation>от корня, м</translation>
    </message>
    <message>
        <source>thickness, cm</source>
        <translation>толщина, см</translation>
    </message>
    <message>
        <source>turns aside</source>
        <translation>повороты в сторону</translation>
    </message>
    <message>
        <source>splits below</source>
        <translation>разделений ниже</translation>
    </message>
    <message>
        <source>order</source>
        <translation>порядок</translation>
    </message>
    <message>
        <source>height</source>
        <translation>высота</translation>
    </message>
    <message>
        <source>rootLength</source>
        <translation>длина от корня</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>толщина</translation>
    </message>
    <message>
        <source>What the curve runs over: the number of turns aside from the trunk (order), or the height in metres, the length from the root in metres, the thickness in centimetres of the branch that splits, at its base.</source>
        <translation>По чему идёт кривая: число поворотов в сторону от ствола (порядок) или высота в метрах, длина от корня в метрах, толщина в сантиметрах у основания ветви, которая разделяется.</translation>
    </message>
    <message>
        <source>It places the leaves of twigs: their Number is 0.</source>
        <translation>Размещает листья на веточках: их число равно 0.</translation>
    </message>
    <message>
        <source>How many strands the trunk has, S: each of them ends in a twig of its own, so a tree has as many twigs and 2S - 1 branches.</source>
        <translation>Сколько прядей в стволе, S: каждая заканчивается своей веточкой, поэтому веточек столько же, а ветвей 2S - 1.</translation>
    </message>
    <message>
        <source>Height of the trunk</source>
        <translation>Высота ствола</translation>
    </message>
    <message>
        <source>How long the trunk is below its first split.</source>
        <translation>Какой длины ствол до первого разделения.</translation>
    </message>
    <message>
        <source>Inherited length</source>
        <translation>Наследуемая длина</translation>
    </message>
    <message>
        <source>The length that the first branches inherit, L: every split hands a part of it on.</source>
        <translation>Длина, которую наследуют первые ветви, L: каждое разделение передаёт её часть дальше.</translation>
    </message>
    <message>
        <source>Thickness of a strand</source>
        <translation>Толщина пряди</translation>
    </message>
    <message>
        <source>How thick a branch of one strand is. One of S strands has the diameter d = this times the root of S, so that the wood above a split has the area of that below.</source>
        <translation>Какой толщины ветвь из одной пряди. У ветви из S прядей диаметр d = это значение, умноженное на корень из S, так что сечение древесины выше разделения такое же, как ниже.</translation>
    </message>
    <message>
        <source>Strands of the leader</source>
        <translation>Пряди ведущей ветви</translation>
    </message>
    <message>
        <source>Shares</source>
        <translation>Доли</translation>
    </message>
    <message>
        <source>The part of the strands that goes on in the leader at a split, k_s: it gets S1 = 1 + (k_s (S - 2) rounded up), the side branch the rest. 0.5 splits evenly, 1 makes a single axis with twigs.</source>
        <translation>Часть прядей, которая при разделении идёт дальше в ведущую ветвь, k_s: она получает S1 = 1 + (k_s (S - 2), округлённое вверх), боковая ветвь остальные. 0,5 делит поровну, 1 даёт единственную ось с веточками.</translation>
    </message>
    <message>
        <source>Turn of the leader</source>
        <translation>Поворот ведущей ветви</translation>
    </message>
    <message>
        <source>Gravicentralism, k_c: the leader turns aside by this times the split angle times the root of S2 / S, the side branch by the rest. 0 goes straight on, as many trunks do.</source>
        <translation>Гравицентрализм, k_c: ведущая ветвь отклоняется на это значение, умноженное на угол разделения и на корень из S2 / S, боковая ветвь на остаток. 0 идёт прямо, как многие стволы.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Углы</translation>
    </message>
    <message>
        <source>The angle between leader and side branch at a split, α.</source>
        <translation>Угол между ведущей и боковой ветвями при разделении, α.</translation>
    </message>
    <message>
        <source>Turn of the plane</source>
        <translation>Поворот плоскости</translation>
    </message>
    <message>
        <source>How far the plane of a split is turned about the branch against the one before: 90 and 137.5 wind about it, 0 and 180 lie flat.</source>
        <translation>Насколько плоскость разделения повёрнута вокруг ветви относительно предыдущей: 90 и 137,5 обвивают её, 0 и 180 лежат в одной плоскости.</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Свисание</translation>
    </message>
    <message>
        <source>Gravimorphism: how far every branch turns towards the ground after a split, until it hangs.</source>
        <translation>Гравиморфизм: насколько каждая ветвь после разделения поворачивает к земле, пока не повиснет.</translation>
    </message>
    <message>
        <source>Min length ratio</source>
        <translation>Наименьшее отношение длин</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Длины</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at least this part, k_m.</source>
        <translation>Ветвь наследует длину той, что ниже, умноженную на корень из своей доли прядей, но не меньше этой части, k_m.</translation>
    </message>
    <message>
        <source>Max length ratio</source>
        <translation>Наибольшее отношение длин</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at most this part, k_M.</source>
        <translation>Ветвь наследует длину той, что ниже, умноженную на корень из своей доли прядей, но не больше этой части, k_M.</translation>
    </message>
    <message>
        <source>Drawn length</source>
        <translation>Рисуемая длина</translation>
    </message>
    <message>
        <source>How much of the inherited length the branches above a split are drawn with, k_l; what they hand on stays the same.</source>
        <translation>Какая часть наследуемой длины рисуется у ветвей выше разделения, k_l; передаваемое дальше не меняется.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Разброс</translation>
    </message>
    <message>
        <source>How far angles stray from the curves, by the seed: 0 gives every tree the same form.</source>
        <translation>Насколько углы в зависимости от зерна отходят от кривых: 0 даёт всем деревьям одну форму.</translation>
    </message>
    <message>
        <source>Factors by depth</source>
        <translation>Множители по глубине</translation>
    </message>
    <message>
        <source>A factor of this value over the depth: how many splits lie below.</source>
        <translation>Множитель этого значения по глубине: сколько разделений лежит ниже.</translation>
    </message>
    <message>
        <source>What curves run over</source>
        <translation>По чему идут кривые</translation>
    </message>
    <message>
        <source>How many leaves a twig of one strand bears.</source>
        <translation>Сколько листьев несёт веточка из одной пряди.</translation>
    </message>
    <message>
        <source>The angle between the leaves and their twig.</source>
        <translation>Угол между листьями и их веточкой.</translation>
    </message>
    <message>
        <source>The turn about the twig from one leaf to the next.</source>
        <translation>Поворот вокруг веточки от одного листа к следующему.</translation>
    </message>
    <message>
        <source>Strand model</source>
        <translation>Модель прядей</translation>
    </message>
    <message>
        <source>A trunk of strands that split again and again until each is a twig: drawn curves say how. Holton 1994.</source>
        <translation>Ствол из прядей, которые разделяются снова и снова, пока каждая не станет веточкой: как, говорят нарисованные кривые. Holton 1994.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Нет</translation>
    </message>
    <message>
        <source>Attributes for a shader</source>
        <translation>Атрибуты для шейдера</translation>
    </message>
    <message>
        <source>CryEngine vertex colours</source>
        <translation>Цвета вершин CryEngine</translation>
    </message>
    <message>
        <source>Unity Tree Creator colours</source>
        <translation>Цвета Unity Tree Creator</translation>
    </message>
    <message>
        <source>Bones with clips</source>
        <translation>Кости с клипами</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Кости</translation>
    </message>
    <message>
        <source>How many of the thickest stems get a bone of their own; the others follow theirs. Only with bones.</source>
        <translation>Сколько самых толстых ветвей получат свою кость; остальные следуют за ними. Только с костями.</translation>
    </message>
    <message>
        <source>%1 cannot hold what moves in the wind; choose glTF</source>
        <translation>%1 не хранит движение на ветру; выберите glTF</translation>
    </message>
    <message>
        <source>1 is a strong gale, 22 m/s; beyond it is a storm.</source>
        <translation>1 — сильный шторм, 22 м/с; дальше буря.</translation>
    </message>
    <message>
        <source>Where it blows to; the arrow in the picture can be dragged too.</source>
        <translation>Куда дует; можно тянуть и стрелку на картинке.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Порывы</translation>
    </message>
    <message>
        <source>How much of the strength comes and goes.</source>
        <translation>Какая часть силы приходит и уходит.</translation>
    </message>
    <message>
        <source>Flexibility</source>
        <translation>Гибкость</translation>
    </message>
    <message>
        <source>How far the wood bends in the wind: 0 is stiff, 2 bends twice as far. The tree in still air stays as it is.</source>
        <translation>Насколько дерево гнётся на ветру: 0 — жёсткое, 2 — вдвое сильнее. В тихую погоду оно не меняется.</translation>
    </message>
    <message>
        <source>Unreal Pivot Painter 2 pictures</source>
        <translation>Картинки для Pivot Painter 2 (Unreal)</translation>
    </message>
    <message>
        <source>What lets the tree sway in another program: vertex attributes and a table for a shader, vertex colours as an engine reads them (COLOR_0 then tints the tree where they are not read), pictures of pivots for Unreal, or bones with clips of wind and growth.</source>
        <translation>Что качает дерево в другой программе: атрибуты вершин и таблица для шейдера, цвета вершин, как их читает движок (COLOR_0 окрашивает дерево там, где их не читают), картинки точек вращения для Unreal или кости с клипами ветра и роста.</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>ветвь</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>горизонталь</translation>
    </message>
    <message>
        <source>Nothing attracts the branches: Attraction up is 0.</source>
        <translation>Ветви никуда не стремятся: Стремление вверх равно 0.</translation>
    </message>
    <message>
        <source>Attraction axis</source>
        <translation>Ось стремления вверх</translation>
    </message>
    <message>
        <source>What attraction turns a branch about. &apos;stem&apos;, as the paper prints it: its own axis, so that one that lies on its side stays. &apos;horizontal&apos;: all hang, or reach up, alike.</source>
        <translation>Вокруг чего стремление вверх поворачивает ветвь. «ветвь», как напечатано в статье: вокруг своей оси, так что лежащая на боку остаётся. «горизонталь»: все свисают или тянутся вверх одинаково.</translation>
    </message>
    <message>
        <source>Sun strength</source>
        <translation>Сила солнца</translation>
    </message>
    <message>
        <source>0 is an overcast day without shadows, 1 a clear one.</source>
        <translation>0 — пасмурный день без теней, 1 — ясный.</translation>
    </message>
    <message>
        <source>The colour of its light: low is warm and red, high is cold and blue.</source>
        <translation>Цвет его света: низкая — тёплый и красный, высокая — холодный и синий.</translation>
    </message>
    <message>
        <source>Sky strength</source>
        <translation>Сила неба</translation>
    </message>
    <message>
        <source>How bright the sky is: what lights the shadows.</source>
        <translation>Насколько ярко небо: оно освещает тени.</translation>
    </message>
    <message>
        <source>The colour of the sky: low is warm, high is blue.</source>
        <translation>Цвет неба: низкая — тёплый, высокая — синий.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Экспозиция</translation>
    </message>
    <message>
        <source>Makes the whole picture brighter or darker: each stop doubles the light.</source>
        <translation>Делает всю картинку ярче или темнее: каждая ступень удваивает свет.</translation>
    </message>
    <message>
        <source>Colour variation</source>
        <translation>Разброс цвета</translation>
    </message>
    <message>
        <source>How much leaves differ in hue and lightness, in the window and in its pictures. 0: all are alike.</source>
        <translation>Насколько листья различаются оттенком и светлотой, в окне и на его картинках. 0: все одинаковы.</translation>
    </message>
    <message>
        <source>Remeshed in voxels</source>
        <translation>Новая сетка из вокселей</translation>
    </message>
    <message>
        <source>One solid</source>
        <translation>Единое тело</translation>
    </message>
    <message>
        <source>For printing: all wood as one closed surface, without leaves. Of up to 5,000 stems.</source>
        <translation>Для печати: вся древесина как одна замкнутая поверхность, без листьев. Не более 5000 побегов.</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Размер вокселя</translation>
    </message>
    <message>
        <source>The edge of the cubes that a solid is made of, in metres of the tree. Thinner wood becomes as thick.</source>
        <translation>Ребро кубов, из которых состоит тело, в метрах дерева. Более тонкая древесина становится такой толщины.</translation>
    </message>
    <message>
        <source>one solid has no levels of detail and does not move in the wind</source>
        <translation>единое тело не имеет уровней детализации и не движется на ветру</translation>
    </message>
    <message>
        <source>How often the bark picture would repeat from the trunk&apos;s base to its tip if it stayed as thick. Thinner wood shows it smaller, undistorted.</source>
        <translation>Сколько раз рисунок коры повторился бы от основания ствола до вершины, если бы тот оставался той же толщины. На тонкой древесине он мельче и не искажён.</translation>
    </message>
    <message>
        <source>The picture on branches, which have a material of their own then. The trunk shows it where it is as thin as they are. Empty: as the trunk.</source>
        <translation>Картинка на ветвях, у которых тогда свой материал. Ствол показывает её там, где он так же тонок. Пусто: как ствол.</translation>
    </message>
    <message>
        <source>curved</source>
        <translation>изогнутый</translation>
    </message>
    <message>
        <source>cupped</source>
        <translation>чашевидный</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>волнистый</translation>
    </message>
    <message>
        <source>rolled</source>
        <translation>скрученный</translation>
    </message>
    <message>
        <source>The leaf has a mesh of its own.</source>
        <translation>У листа своя сетка.</translation>
    </message>
    <message>
        <source>The mesh keeps its proportions.</source>
        <translation>Сетка сохраняет свои пропорции.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Сетка</translation>
    </message>
    <message>
        <source>A mesh in place of a card: mesh:curved and the like, or a file (.obj, .glb) whose foot is the origin; its path starts at the file&apos;s folder. The leaf texture lies on it by its texture coordinates.</source>
        <translation>Сетка вместо карточки: mesh:curved и подобные, или файл (.obj, .glb), основание которого — начало координат; путь начинается в папке файла. Текстура листа ложится по её текстурным координатам.</translation>
    </message>
    <message>
        <source>Leaf texture 2</source>
        <translation>Текстура листа 2</translation>
    </message>
    <message>
        <source>Leaf texture 3</source>
        <translation>Текстура листа 3</translation>
    </message>
    <message>
        <source>Leaf texture 4</source>
        <translation>Текстура листа 4</translation>
    </message>
    <message>
        <source>Mesh 2</source>
        <translation>Сетка 2</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Виды</translation>
    </message>
    <message>
        <source>Mesh 3</source>
        <translation>Сетка 3</translation>
    </message>
    <message>
        <source>Mesh 4</source>
        <translation>Сетка 4</translation>
    </message>
    <message>
        <source>Share 2</source>
        <translation>Доля 2</translation>
    </message>
    <message>
        <source>Share 3</source>
        <translation>Доля 3</translation>
    </message>
    <message>
        <source>Share 4</source>
        <translation>Доля 4</translation>
    </message>
    <message>
        <source>The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind.</source>
        <translation>Картинка на листьях этого вида, у которых тогда свой материал. Пусто: как первый вид.</translation>
    </message>
    <message>
        <source>The mesh of leaves of this kind. Empty: as the first kind.</source>
        <translation>Сетка листьев этого вида. Пусто: как первый вид.</translation>
    </message>
    <message>
        <source>The part of the leaves that is of this kind, with a texture or a mesh of its own.</source>
        <translation>Часть листьев этого вида, со своей текстурой или сеткой.</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>встроенная</translation>
    </message>
    <message>
        <source>Bark of branches 1</source>
        <translation>Кора ветвей 1</translation>
    </message>
    <message>
        <source>as the trunk</source>
        <translation>как ствол</translation>
    </message>
    <message>
        <source>Bark of branches 2</source>
        <translation>Кора ветвей 2</translation>
    </message>
    <message>
        <source>The picture on branches of branches, which have a material of their own then. Thin branches show it too. Empty: as branches 1.</source>
        <translation>Картинка на ветвях ветвей, у которых тогда свой материал. Тонкие ветви тоже показывают её. Пусто: как ветви 1.</translation>
    </message>
    <message>
        <source>as branches 1</source>
        <translation>как ветви 1</translation>
    </message>
    <message>
        <source>Bark of branches 3</source>
        <translation>Кора ветвей 3</translation>
    </message>
    <message>
        <source>The picture on branches 3 and deeper ones, which have a material of their own then. Thin branches 2 show it too. Empty: as branches 2.</source>
        <translation>Картинка на ветвях 3 и глубже, у которых тогда свой материал. Тонкие ветви 2 тоже показывают её. Пусто: как ветви 2.</translation>
    </message>
    <message>
        <source>as branches 2</source>
        <translation>как ветви 2</translation>
    </message>
    <message>
        <source>as the first kind</source>
        <translation>как первый вид</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Смещение поверхности</translation>
    </message>
    <message>
        <source>The relief of the bark as triangles, in cells of so many metres: 0.02 for a trunk seen from near; 0: none. Only level of detail 0 gets it.</source>
        <translation>Рельеф коры в виде треугольников, в ячейках по столько метров: 0,02 для ствола вблизи; 0: без него. Его получает только уровень детализации 0.</translation>
    </message>
    <message>
        <source>Strength of displacement</source>
        <translation>Сила смещения</translation>
    </message>
    <message>
        <source>How deep displaced bark is: 1 is what the picture of its normals shows. Seen from near it may be more.</source>
        <translation>Насколько глубока смещённая кора: 1 — как показывает картинка её нормалей. Вблизи может быть и больше.</translation>
    </message>
    <message>
        <source>only the full model&apos;s level of detail 0 has displaced bark</source>
        <translation>смещённая кора есть только у уровня детализации 0 полной модели</translation>
    </message>
    <message>
        <source>Sun and shade</source>
        <translation>Солнце и тень</translation>
    </message>
    <message>
        <source>How much leaves that grow in the shade of the crown differ from those in the sun: at 1 they are 1.6 times as long and wide, and darker in the window and its pictures.</source>
        <translation>Насколько листья, растущие в тени кроны, отличаются от листьев на солнце: при 1 они в 1,6 раза длиннее и шире, а в окне и на его картинках темнее.</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>Выпуклость</translation>
    </message>
    <message>
        <source>How far the middle of a cluster of blossoms stands out: 0 is a flat card, at 1 its edge lies half its width lower.</source>
        <translation>Насколько выступает середина соцветия: 0 — плоская карточка, при 1 её край лежит на половину ширины ниже.</translation>
    </message>
    <message>
        <source>How many lobes a half, or a hand-shaped leaf, has. Of blossoms: how many flowers. Of spruce twigs: how many pairs of side twigs.</source>
        <translation>Сколько лопастей у половины или у пальчатого листа. У соцветий: сколько цветков. У еловых веточек: сколько пар боковых веточек.</translation>
    </message>
    <message>
        <source>random</source>
        <translation>случайность</translation>
    </message>
    <message>
        <source>autumn winter spring date</source>
        <translation>осень зима весна дата</translation>
    </message>
    <message>
        <source>stiff sway</source>
        <translation>жёсткость качание</translation>
    </message>
    <message>
        <source>root collar buttress base</source>
        <translation>корневая шейка контрфорсы основание</translation>
    </message>
    <message>
        <source>size</source>
        <translation>размер</translation>
    </message>
    <message>
        <source>hue tint random</source>
        <translation>оттенок цвет случайность</translation>
    </message>
    <message>
        <source>gravity droop weeping</source>
        <translation>гравитация поникание плакучая</translation>
    </message>
    <message>
        <source>crown base height clear</source>
        <translation>высота кроны чистый ствол</translation>
    </message>
    <message>
        <source>order recursion generations</source>
        <translation>порядок рекурсия поколения</translation>
    </message>
    <message>
        <source>girth radius diameter width</source>
        <translation>обхват радиус диаметр ширина</translation>
    </message>
    <message>
        <source>gravity droop weeping hang</source>
        <translation>гравитация поникание плакучая свисание</translation>
    </message>
    <message>
        <source>shrub clump multi-stem</source>
        <translation>куст многоствольный</translation>
    </message>
    <message>
        <source>count density</source>
        <translation>количество густота</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>наклон</translation>
    </message>
    <message>
        <source>twist spiral phyllotaxis</source>
        <translation>скручивание спираль филлотаксис</translation>
    </message>
    <message>
        <source>bend arch</source>
        <translation>изгиб дуга</translation>
    </message>
    <message>
        <source>fork clone</source>
        <translation>развилка клон</translation>
    </message>
    <message>
        <source>foliage count density</source>
        <translation>листва количество густота</translation>
    </message>
    <message>
        <source>envelope crop shape</source>
        <translation>оболочка обрезка форма</translation>
    </message>
    <message>
        <source>As an attribute</source>
        <translation>Как атрибут</translation>
    </message>
    <message>
        <source>In the vertex colours</source>
        <translation>В цветах вершин</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Затенение окружением</translation>
    </message>
    <message>
        <source>How much of the sky vertices see, in glTF files: as an attribute _OCCLUSION for shaders, or multiplied into the vertex colours (COLOR_0), which darkens the crown in programs that compute this light themselves.</source>
        <translation>Сколько неба видят вершины, в файлах glTF: как атрибут _OCCLUSION для шейдеров или умноженное на цвета вершин (COLOR_0), что затемняет крону в программах, которые сами рассчитывают этот свет.</translation>
    </message>
    <message>
        <source>%1 cannot hold vertex colours; choose glTF</source>
        <translation>%1 не хранит цвета вершин; выберите glTF</translation>
    </message>
    <message>
        <source>the colours of this wind hold the occlusion already</source>
        <translation>цвета этого ветра уже содержат затенение</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Освещённое</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Нормали</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Шероховатость</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> МБ</translation>
    </message>
    <message>
        <source>Unreal Engine</source>
        <translation>Unreal Engine</translation>
    </message>
    <message>
        <source>Import the LOD0 file, then the others in the mesh editor under Level Of Detail; the pictures of pivots go to the material function PivotPainter2FoliageShader.</source>
        <translation>Импортируйте файл LOD0, остальные — в редакторе сетки в разделе Level Of Detail; изображения точек вращения идут в функцию материала PivotPainter2FoliageShader.</translation>
    </message>
    <message>
        <source>Unity</source>
        <translation>Unity</translation>
    </message>
    <message>
        <source>With the package glTFast; put the four objects under one with an LOD Group; the mask maps beside the file belong into the HDRP material.</source>
        <translation>С пакетом glTFast; четыре объекта поместите под один с LOD Group; карты-маски рядом с файлом — для материала HDRP.</translation>
    </message>
    <message>
        <source>Godot</source>
        <translation>Godot</translation>
    </message>
    <message>
        <source>Give each of the four meshes a visibility range.</source>
        <translation>Задайте каждой из четырёх сеток диапазон видимости.</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>The attribute _OCCLUSION can be mixed into the material.</source>
        <translation>Атрибут _OCCLUSION можно подмешать в материал.</translation>
    </message>
    <message>
        <source>three.js</source>
        <translation>three.js</translation>
    </message>
    <message>
        <source>Add the four scenes to one THREE.LOD.</source>
        <translation>Добавьте четыре сцены в один THREE.LOD.</translation>
    </message>
    <message>
        <source>OpenGL: green is up</source>
        <translation>OpenGL: зелёный вверх</translation>
    </message>
    <message>
        <source>DirectX: green is down</source>
        <translation>DirectX: зелёный вниз</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metal</source>
        <translation>Затенение, шероховатость, металл</translation>
    </message>
    <message>
        <source>Unity&apos;s mask map</source>
        <translation>Карта-маска Unity</translation>
    </message>
    <message>
        <source>Pixels that a picture may be wide or high: larger ones are halved until they are no larger; 0: as they are. PNG pictures only.</source>
        <translation>Сколько пикселей может быть в ширину или высоту изображения: большие делятся пополам, пока не подойдут; 0 — как есть. Только PNG.</translation>
    </message>
    <message>
        <source>Normal maps</source>
        <translation>Карты нормалей</translation>
    </message>
    <message>
        <source>Which way the green of normal maps points: up, as OpenGL, Blender, Unity and Godot have it, or down, as DirectX and Unreal.</source>
        <translation>Куда указывает зелёный в картах нормалей: вверх, как в OpenGL, Blender, Unity и Godot, или вниз, как в DirectX и Unreal.</translation>
    </message>
    <message>
        <source>Packed maps</source>
        <translation>Упакованные карты</translation>
    </message>
    <message>
        <source>One picture for several maps: occlusion, roughness and metal in red, green and blue, or Unity&apos;s mask map beside the file (metal, occlusion, detail, smoothness in alpha).</source>
        <translation>Одно изображение для нескольких карт: затенение, шероховатость и металл в красном, зелёном и синем, или карта-маска Unity рядом с файлом (металл, затенение, детали, гладкость в альфа-канале).</translation>
    </message>
    <message>
        <source>Whether leaves have triangles of their own for their back, for programs that do not draw what is seen from behind.</source>
        <translation>Есть ли у листьев свои треугольники для изнанки — для программ, которые не рисуют то, что видно сзади.</translation>
    </message>
    <message>
        <source>%1 shows leaves from both sides by itself</source>
        <translation>%1 и так показывает листья с обеих сторон</translation>
    </message>
    <message>
        <source>pictures that stay where they are cannot be changed; choose copies</source>
        <translation>изображения, которые остаются на месте, изменить нельзя; выберите копии</translation>
    </message>
    <message>
        <source>Of the full model: 0 is the finest, 1 to 3 have about 50, 12 and 4 % of its triangles.</source>
        <translation>У полной модели: 0 — самый подробный, в 1–3 около 50, 12 и 4 % её треугольников.</translation>
    </message>
    <message>
        <source>Babylon.js shows one level of detail at a time, Blender and Godot all four on top of each other, others the finest alone: choose a file for each</source>
        <translation>Babylon.js показывает один уровень детализации, Blender и Godot — все четыре друг на друге, другие — только самый подробный: выберите файл для каждого</translation>
    </message>
    <message>
        <source>No: single faces</source>
        <translation>Нет: одинарные грани</translation>
    </message>
    <message>
        <source>Yes: faces for both sides</source>
        <translation>Да: грани для обеих сторон</translation>
    </message>
    <message>
        <source>Max texture size</source>
        <translation>Макс. размер текстуры</translation>
    </message>
    <message>
        <source>Two-sided leaves</source>
        <translation>Двусторонние листья</translation>
    </message>
    <message>
        <source>Picture cache</source>
        <translation>Кэш изображений</translation>
    </message>
    <message>
        <source>%1 holds colours and pivots of the wind, neither attributes nor bones; choose glTF</source>
        <translation>%1 хранит цвета и центры вращения для ветра, но не атрибуты и кости; выберите glTF</translation>
    </message>
    <message>
        <source>%1 files have their pictures inside</source>
        <translation>в файлах %1 изображения внутри</translation>
    </message>
    <message>
        <source>FBX, binary, centimetres</source>
        <translation>FBX, двоичный, сантиметры</translation>
    </message>
    <message>
        <source>USD, text</source>
        <translation>USD, текст</translation>
    </message>
    <message>
        <source>USD, a package with its pictures</source>
        <translation>USD, пакет с изображениями</translation>
    </message>
    <message>
        <source>Comes through (diffuse transmission)</source>
        <translation>Проходит (диффузное пропускание)</translation>
    </message>
    <message>
        <source>As a list of capsules beside the file</source>
        <translation>Списком капсул рядом с файлом</translation>
    </message>
    <message>
        <source>As Unreal looks for it: UCX_…</source>
        <translation>Как их ищет Unreal: UCX_…</translation>
    </message>
    <message>
        <source>As Godot looks for it: …-colonly</source>
        <translation>Как их ищет Godot: …-colonly</translation>
    </message>
    <message>
        <source>Light through leaves</source>
        <translation>Свет сквозь листья</translation>
    </message>
    <message>
        <source>Of glTF files: leaves with the light behind them are bright (KHR_materials_diffuse_transmission), in programs that know it; others show them as without it.</source>
        <translation>В файлах glTF: листья против света светлые (KHR_materials_diffuse_transmission) в программах, которые это умеют; остальные показывают их как обычно.</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Столкновения</translation>
    </message>
    <message>
        <source>What things bump into: a capsule for each thick stem, as a list beside the file (JSON), or also as meshes with the names that an engine looks for.</source>
        <translation>Обо что ударяются предметы: капсула для каждой толстой ветви, списком рядом с файлом (JSON) или ещё и сетками с именами, которые ищет движок.</translation>
    </message>
    <message>
        <source>%1 does not know light through leaves; choose glTF</source>
        <translation>%1 не знает света сквозь листья; выберите glTF</translation>
    </message>
    <message>
        <source>%1 has no objects whose names an engine looks for; choose glTF or FBX</source>
        <translation>В %1 нет объектов, имена которых ищет движок; выберите glTF или FBX</translation>
    </message>
    <message>
        <source>collision belongs to one level of detail; choose a file for each</source>
        <translation>столкновения относятся к одному уровню детализации; выберите файл для каждого</translation>
    </message>
    <message>
        <source>one solid is its own collision</source>
        <translation>одно тело само служит для столкновений</translation>
    </message>
    <message>
        <source>Arbaro, XML</source>
        <translation>Arbaro, XML</translation>
    </message>
    <message>
        <source>Sapling Tree Gen of Blender, presets</source>
        <translation>Sapling Tree Gen для Blender, заготовки</translation>
    </message>
    <message>
        <source>tree-gen of Blender, presets</source>
        <translation>tree-gen для Blender, заготовки</translation>
    </message>
    <message>
        <source>The most that cached textures and thumbnails may take on the disk. The oldest beyond it are removed.</source>
        <translation>Сколько места на диске могут занимать текстуры и миниатюры. Самые старые сверх этого удаляются.</translation>
    </message>
    <message>
        <source>displacement needs the heights of the bark: a recipe, or beside its picture %1</source>
        <translation>смещению нужны высоты коры: рецепт или рядом с её изображением %1</translation>
    </message>
    <message>
        <source>cannot write %1: there is no folder %2</source>
        <translation>не удаётся записать %1: папки %2 нет</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to export</source>
        <translation>дерево пустое, экспортировать нечего</translation>
    </message>
    <message>
        <source>one solid does not move in the wind</source>
        <translation>одно тело не движется на ветру</translation>
    </message>
    <message>
        <source>there is no choice &apos;%1&apos;</source>
        <translation>выбора «%1» нет</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is one of %2, not &apos;%3&apos;</source>
        <translation>«%1» — одно из %2, а не «%3»</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number without decimals</source>
        <translation>«%1»: «%2» — не целое число</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>«%1»: «%2» — не число</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is between %2 and %3, not %4</source>
        <translation>«%1» — от %2 до %3, а не %4</translation>
    </message>
    <message>
        <source>the name of the model file has no ending; it says the format: %1</source>
        <translation>у имени файла модели нет расширения; оно задаёт формат: %1</translation>
    </message>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>записать «%1» нельзя</translation>
    </message>
    <message>
        <source>this is no XML: %1</source>
        <translation>это не XML: %1</translation>
    </message>
    <message>
        <source>there is no &lt;arbaro&gt; with a &lt;species&gt;</source>
        <translation>нет &lt;arbaro&gt; с элементом &lt;species&gt;</translation>
    </message>
    <message>
        <source>a &lt;param&gt; has a name and a value</source>
        <translation>у &lt;param&gt; должны быть name и value</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known and left out</source>
        <translation>«%1» неизвестно и пропущено</translation>
    </message>
    <message>
        <source>&apos;%1&apos; wants a number, not &apos;%2&apos;; it is left out</source>
        <translation>«%1» должно быть числом, а не «%2»; пропущено</translation>
    </message>
    <message>
        <source>%1 is %2: %3 is out of its range</source>
        <translation>%1 равно %2: %3 вне пределов</translation>
    </message>
    <message>
        <source>these are no values of a tree that is known here</source>
        <translation>это не значения известного здесь дерева</translation>
    </message>
    <message>
        <source>%1: a file of more than 1 MB is no preset of a tree</source>
        <translation>%1: файл больше 1 МБ — не заготовка дерева</translation>
    </message>
    <message>
        <source>a dictionary {…} with the values of a tree is wanted here</source>
        <translation>здесь должен быть словарь {…} со значениями дерева</translation>
    </message>
    <message>
        <source>nothing but comments may follow the values</source>
        <translation>после значений могут идти только комментарии</translation>
    </message>
    <message>
        <source>&apos;=&apos; is wanted behind the name</source>
        <translation>после имени должен стоять знак «=»</translation>
    </message>
    <message>
        <source>this text is not closed</source>
        <translation>этот текст не закрыт</translation>
    </message>
    <message>
        <source>a value is wanted here</source>
        <translation>здесь должно быть значение</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value: only numbers, texts, True, False, None and lists are read</source>
        <translation>«%1» — не значение: читаются только числа, тексты, True, False, None и списки</translation>
    </message>
    <message>
        <source>&apos;%1&apos; or &apos;%2&apos; is wanted here</source>
        <translation>здесь должно стоять «%1» или «%2»</translation>
    </message>
    <message>
        <source>lists are nested too deep</source>
        <translation>списки вложены слишком глубоко</translation>
    </message>
    <message>
        <source>this list is too long</source>
        <translation>этот список слишком длинный</translation>
    </message>
    <message>
        <source>dictionaries are nested too deep</source>
        <translation>словари вложены слишком глубоко</translation>
    </message>
    <message>
        <source>a name in quotes is wanted here</source>
        <translation>здесь должно быть имя в кавычках</translation>
    </message>
    <message>
        <source>&apos;:&apos; is wanted here</source>
        <translation>здесь должно стоять «:»</translation>
    </message>
    <message>
        <source>is too large: a leaf may have at most %1 vertices</source>
        <translation>слишком велик: у листа может быть не больше %1 вершин</translation>
    </message>
    <message>
        <source>is neither .obj nor .glb</source>
        <translation>не .obj и не .glb</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>не удаётся прочитать: %1</translation>
    </message>
    <message>
        <source>is no .glb with a mesh, or too large for a leaf</source>
        <translation>не .glb с сеткой или слишком велик для листа</translation>
    </message>
    <message>
        <source>is no mesh that can be read: %1</source>
        <translation>не сетка, которую можно прочитать: %1</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>не имеет треугольников</translation>
    </message>
    <message>
        <source>displacement in cells of %1 m would make more than %2 million triangles; choose larger cells</source>
        <translation>смещение с ячейкой %1 м дало бы больше %2 млн треугольников; выберите ячейку крупнее</translation>
    </message>
    <message>
        <source>there is no %1; there are %2</source>
        <translation>%1 нет; есть %2</translation>
    </message>
    <message>
        <source>has no length or no width</source>
        <translation>не имеет длины или ширины</translation>
    </message>
    <message>
        <source>a solid of %1 million voxels is too large; voxels of %2 m would do</source>
        <translation>тело из %1 млн вокселей слишком велико; подойдут воксели по %2 м</translation>
    </message>
    <message>
        <source>the tree has %1 stems; a solid is made of %2 at most (fewer Levels or Branches)</source>
        <translation>у дерева %1 ветвей; тело строится не более чем из %2 (меньше уровней или ветвей)</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to make a solid of</source>
        <translation>дерево пустое, тело строить не из чего</translation>
    </message>
    <message>
        <source>point %1 is empty</source>
        <translation>точка %1 пуста</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) is not x:y</source>
        <translation>точка %1 («%2») не вида x:y</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has a y that is no number</source>
        <translation>у точки %1 («%2») y — не число</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has an x that is no number</source>
        <translation>у точки %1 («%2») x — не число</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) must lie to the right of the point before it</source>
        <translation>точка %1 («%2») должна лежать правее предыдущей</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>у кривой не больше %1 точек</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>у %1 нет значения</translation>
    </message>
    <message>
        <source>%1 is not a number: &apos;%2&apos;</source>
        <translation>%1 — не число: «%2»</translation>
    </message>
    <message>
        <source>%1 has no choice &apos;%2&apos;</source>
        <translation>у %1 нет варианта «%2»</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 должно быть целым числом, а не %2</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, not %4; taken as %5</source>
        <translation>%1 должно быть от %2 до %3, а не %4; взято %5</translation>
    </message>
    <message>
        <source>%1: the %2 of point %3 must be from %4 to %5, not %6; taken as the nearest</source>
        <translation>%1: %2 точки %3 должно быть от %4 до %5, а не %6; взято ближайшее</translation>
    </message>
    <message>
        <source>%1 must not hold a line of three quotes: it would end the text in a file</source>
        <translation>%1 не может содержать строку из трёх кавычек: она закрыла бы текст в файле</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>известны: %1</translation>
    </message>
    <message>
        <source>this is a binary tree of the program Kraut, which uses the same file ending; it cannot be read here</source>
        <translation>это двоичное дерево программы Kraut с тем же расширением; здесь его не прочитать</translation>
    </message>
    <message>
        <source>this is UTF-16 text; save it as UTF-8</source>
        <translation>это текст UTF-16; сохраните его в UTF-8</translation>
    </message>
    <message>
        <source>this is not a text file of parameters</source>
        <translation>это не текстовый файл параметров</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>файл пуст</translation>
    </message>
    <message>
        <source>this version cannot grow trees by the method &apos;%1&apos;</source>
        <translation>эта версия не умеет растить деревья методом «%1»</translation>
    </message>
    <message>
        <source>no line %1; read as format %2</source>
        <translation>нет строки %1; прочитано как формат %2</translation>
    </message>
    <message>
        <source>a file with the method &apos;%1&apos; says %2</source>
        <translation>в файле с методом «%1» пишут %2</translation>
    </message>
    <message>
        <source>the text is not closed: a line of three quotes is missing</source>
        <translation>текст не закрыт: нет строки из трёх кавычек</translation>
    </message>
    <message>
        <source>this character is not UTF-8</source>
        <translation>этот символ не UTF-8</translation>
    </message>
    <message>
        <source>this line is not &apos;Key = Value&apos;</source>
        <translation>эта строка не вида «Ключ = Значение»</translation>
    </message>
    <message>
        <source>the quote is not closed</source>
        <translation>кавычка не закрыта</translation>
    </message>
    <message>
        <source>nothing but a comment may follow the closing quote</source>
        <translation>после закрывающей кавычки может идти только комментарий</translation>
    </message>
    <message>
        <source>there is no key in front of &apos;=&apos;</source>
        <translation>перед «=» нет ключа</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos; is kept</source>
        <translation>неизвестный ключ «%1» сохраняется</translation>
    </message>
    <message>
        <source>Format must be a whole number from 1, not &apos;%1&apos;</source>
        <translation>Format должен быть целым числом от 1, а не «%1»</translation>
    </message>
    <message>
        <source>the file has format %1, but this version reads only up to %2; a newer Stromar is needed</source>
        <translation>у файла формат %1, а эта версия читает только до %2; нужен более новый Stromar</translation>
    </message>
    <message>
        <source>a second value for %1; the first is in line %2</source>
        <translation>второе значение для %1; первое в строке %2</translation>
    </message>
    <message>
        <source>this is a folder, not a .tree file</source>
        <translation>это папка, а не файл .tree</translation>
    </message>
    <message>
        <source>a backdrop is a picture, .png or .jpg, or a panorama, .hdr: not %1</source>
        <translation>фон — изображение .png или .jpg либо панорама .hdr, а не %1</translation>
    </message>
    <message>
        <source>cannot read the backdrop %1</source>
        <translation>не удаётся прочитать фон %1</translation>
    </message>
    <message>
        <source>this grammar makes %1 modules in %2 derivations; at most %3 are allowed</source>
        <translation>эта грамматика даёт %1 модулей за %2 шагов вывода; допустимо не больше %3</translation>
    </message>
    <message>
        <source>the grammar draws nothing: its word has no F with a length after %1 derivations</source>
        <translation>грамматика ничего не рисует: в её слове после %1 шагов вывода нет F с длиной</translation>
    </message>
    <message>
        <source>this expression is nested too deeply</source>
        <translation>это выражение вложено слишком глубоко</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not defined here</source>
        <translation>«%1» здесь не определено</translation>
    </message>
    <message>
        <source>there is no function &apos;%1&apos;</source>
        <translation>функции «%1» нет</translation>
    </message>
    <message>
        <source>%1() takes %2 number, not %3</source>
        <translation>%1() принимает чисел: %2, а не %3</translation>
    </message>
    <message>
        <source>%1() takes %2 numbers, not %3</source>
        <translation>%1() принимает чисел: %2, а не %3</translation>
    </message>
    <message>
        <source>this is no finite number</source>
        <translation>это не конечное число</translation>
    </message>
    <message>
        <source>this comment has no end</source>
        <translation>у этого комментария нет конца</translation>
    </message>
    <message>
        <source>expected &apos;%1&apos;</source>
        <translation>ожидалось «%1»</translation>
    </message>
    <message>
        <source>this bracket is not closed</source>
        <translation>эта скобка не закрыта</translation>
    </message>
    <message>
        <source>a number is missing here</source>
        <translation>здесь не хватает числа</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>это не число</translation>
    </message>
    <message>
        <source>the bracket of this call is not closed</source>
        <translation>скобка этого вызова не закрыта</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>«%1» — не число</translation>
    </message>
    <message>
        <source>the axiom is missing: axiom: …</source>
        <translation>нет аксиомы: axiom: …</translation>
    </message>
    <message>
        <source>only #define and #ignore are known</source>
        <translation>известны только #define и #ignore</translation>
    </message>
    <message>
        <source>the number of derivations is the value Derivations, not a line of the grammar</source>
        <translation>число шагов вывода — это значение Derivations, а не строка грамматики</translation>
    </message>
    <message>
        <source>there is an axiom already</source>
        <translation>аксиома уже есть</translation>
    </message>
    <message>
        <source>the axiom is empty</source>
        <translation>аксиома пуста</translation>
    </message>
    <message>
        <source>#define needs a name</source>
        <translation>для #define нужно имя</translation>
    </message>
    <message>
        <source>nothing may follow the value</source>
        <translation>после значения ничего быть не может</translation>
    </message>
    <message>
        <source>a value that is defined cannot depend on chance</source>
        <translation>определяемое значение не может зависеть от случая</translation>
    </message>
    <message>
        <source>polygons { . } are not supported; use ~L for a leaf</source>
        <translation>многоугольники { . } не поддерживаются; для листа есть ~L</translation>
    </message>
    <message>
        <source>after ~ stands L (leaf), B (blossom) or K (fruit)</source>
        <translation>после ~ стоит L (лист), B (цветок) или K (плод)</translation>
    </message>
    <message>
        <source>a letter is missing here</source>
        <translation>здесь не хватает буквы</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no letter of a word</source>
        <translation>«%1» — не буква слова</translation>
    </message>
    <message>
        <source>the bracket of this module&apos;s numbers is not closed</source>
        <translation>скобка с числами этого модуля не закрыта</translation>
    </message>
    <message>
        <source>there is no [ for this ]</source>
        <translation>для этой ] нет [</translation>
    </message>
    <message>
        <source>there is no ] for this [</source>
        <translation>для этой [ нет ]</translation>
    </message>
    <message>
        <source>here stands the name of a parameter</source>
        <translation>здесь должно стоять имя параметра</translation>
    </message>
    <message>
        <source>expected &apos;)&apos; after the parameters</source>
        <translation>после параметров ожидалась «)»</translation>
    </message>
    <message>
        <source>a production rewrites one module: A(x) : condition -&gt; successor</source>
        <translation>правило переписывает один модуль: A(x) : условие -&gt; результат</translation>
    </message>
    <message>
        <source>a production has at most 32 parameters</source>
        <translation>у правила не больше 32 параметров</translation>
    </message>
    <message>
        <source>brackets in a context are not supported</source>
        <translation>скобки в контексте не поддерживаются</translation>
    </message>
    <message>
        <source>expected &apos;-&gt;&apos;</source>
        <translation>ожидалось «-&gt;»</translation>
    </message>
    <message>
        <source>this production never matches: no word has %1 with %2 numbers</source>
        <translation>это правило никогда не применяется: ни в одном слове нет %1, у которого чисел %2</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 modules</source>
        <translation>в слове этой грамматики было бы больше %1 модулей</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 numbers</source>
        <translation>в слове этой грамматики было бы больше %1 чисел</translation>
    </message>
    <message>
        <source>a number of %1 is not finite when %2 is rewritten</source>
        <translation>число модуля %1 не конечно при переписывании %2</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>cannot write %1</source>
        <translation>не удаётся записать %1</translation>
    </message>
    <message>
        <source>cannot write %1: the file on the disk is incomplete</source>
        <translation>не удаётся записать %1: файл на диске неполон</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>не удаётся прочитать %1</translation>
    </message>
    <message>
        <source>, did you mean &apos;%1&apos;?</source>
        <translation>, возможно, «%1»?</translation>
    </message>
    <message>
        <source>as they are</source>
        <translation>как есть</translation>
    </message>
    <message>
        <source>a row of trees has a file for each level of detail; choose that or one level</source>
        <translation>у ряда деревьев по файлу на каждый уровень детализации; выберите это или один уровень</translation>
    </message>
    <message>
        <source>a row of trees stands still; choose one tree or no wind</source>
        <translation>ряд деревьев неподвижен; выберите одно дерево или без ветра</translation>
    </message>
    <message>
        <source>a row of trees has no collision; choose one tree or none</source>
        <translation>у ряда деревьев нет столкновений; выберите одно дерево или без них</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>автоматически</translation>
    </message>
    <message>
        <source>never</source>
        <translation>никогда</translation>
    </message>
    <message>
        <source>Sun colour</source>
        <translation>Цвет солнца</translation>
    </message>
    <message>
        <source>Sky colour</source>
        <translation>Цвет неба</translation>
    </message>
    <message>
        <source>leaves are spread along their stem as in the paper</source>
        <translation>листья распределены по ветви, как в статье</translation>
    </message>
    <message>
        <source>there it roughens the mesh of the trunk</source>
        <translation>там он делает сетку ствола неровной</translation>
    </message>
    <message>
        <source>trunks lean by TrunksLean</source>
        <translation>наклон стволов задаёт TrunksLean</translation>
    </message>
    <message>
        <source>trunks are turned by chance</source>
        <translation>стволы повёрнуты случайно</translation>
    </message>
    <message>
        <source>of its shapes of discs and spheres an oval leaf is nearest</source>
        <translation>из его дисков и сфер ближе всего овальный лист</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be had: %2</source>
        <translation>«%1» не перенести: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; becomes %2 = %3: %4</source>
        <translation>«%1» становится %2 = %3: %4</translation>
    </message>
    <message>
        <source>its shapes 8 and 10 have no formula here; the nearest is a tapered cylinder</source>
        <translation>для его форм 8 и 10 здесь нет формулы; ближе всего сужающийся цилиндр</translation>
    </message>
    <message>
        <source>branches have no bare base here</source>
        <translation>у ветвей здесь нет голого основания</translation>
    </message>
    <message>
        <source>the trunk splits from its first segment on</source>
        <translation>ствол ветвится с первого сегмента</translation>
    </message>
    <message>
        <source>splits are spread evenly</source>
        <translation>развилки распределены равномерно</translation>
    </message>
    <message>
        <source>branches are as thick as RatioPower says</source>
        <translation>толщину ветвей задаёт RatioPower</translation>
    </message>
    <message>
        <source>branches are not drawn outwards here</source>
        <translation>ветви здесь не тянутся наружу</translation>
    </message>
    <message>
        <source>branches are spread evenly along the trunk</source>
        <translation>ветви распределены по стволу равномерно</translation>
    </message>
    <message>
        <source>rings of branches are Whorl here</source>
        <translation>кольца ветвей здесь задаёт Whorl</translation>
    </message>
    <message>
        <source>the trunk does not thin towards branches</source>
        <translation>ствол не сужается к ветвям</translation>
    </message>
    <message>
        <source>the envelope ends at the crown&apos;s base</source>
        <translation>оболочка кончается у основания кроны</translation>
    </message>
    <message>
        <source>leaves of a stem are equally large</source>
        <translation>листья одной ветви одинаковы по размеру</translation>
    </message>
    <message>
        <source>leaves turn to the light by LeafBend</source>
        <translation>к свету листья поворачивает LeafBend</translation>
    </message>
    <message>
        <source>a negative number there is a random one</source>
        <translation>отрицательное число там означает случайное</translation>
    </message>
    <message>
        <source>stems bend by CurveV</source>
        <translation>стебли изгибает CurveV</translation>
    </message>
    <message>
        <source>whorls are counted by their branches, and between alternate and opposite there is nothing</source>
        <translation>мутовки считаются по ветвям, а между очередными и супротивными ничего нет</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Сжатие</translation>
    </message>
    <message>
        <source>%1 cannot be compressed; choose glTF</source>
        <translation>%1 нельзя сжать; выберите glTF</translation>
    </message>
    <message>
        <source>what moves in the wind cannot be compressed</source>
        <translation>то, что движется на ветру, нельзя сжать</translation>
    </message>
    <message>
        <source>Quantised (KHR_mesh_quantization)</source>
        <translation>Квантование (KHR_mesh_quantization)</translation>
    </message>
    <message>
        <source>Quantised, then meshopt (EXT_meshopt_compression)</source>
        <translation>Квантование, затем meshopt (EXT_meshopt_compression)</translation>
    </message>
    <message>
        <source>Of glTF files: vertices in 16 and 8 bits, which most programs read, or these compressed by meshoptimizer as well, for web pages whose loader has its decoder.</source>
        <translation>Файлы glTF: вершины по 16 и 8 битов, которые читает большинство программ, или ещё и сжатые meshoptimizer, для веб-страниц, загрузчик которых имеет его декодер.</translation>
    </message>
    <message>
        <source>leaves that move in the wind cannot be instances</source>
        <translation>листья, которые движутся на ветру, не могут быть экземплярами</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Экземпляры</translation>
    </message>
    <message>
        <source>instances belong to one level of detail; choose a file for each</source>
        <translation>экземпляры относятся к одному уровню детализации; выберите файл для каждого</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>JPEG where it can be</source>
        <translation>JPEG, где возможно</translation>
    </message>
    <message>
        <source>Texture format</source>
        <translation>Формат текстур</translation>
    </message>
    <message>
        <source>What pictures of bark colours are written as: JPEG has about a fifth of the bytes. Pictures with alpha, normals and roughness stay PNG.</source>
        <translation>В чём записываются цвета коры: у JPEG около пятой части байтов. Изображения с альфой, нормали и шероховатость остаются PNG.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Объекты</translation>
    </message>
    <message>
        <source>Texture atlas</source>
        <translation>Атлас текстур</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>материалы</translation>
    </message>
    <message>
        <source>texture coordinates</source>
        <translation>координаты текстуры</translation>
    </message>
    <message>
        <source>normals (programs make their own)</source>
        <translation>нормали (программы вычисляют свои)</translation>
    </message>
    <message>
        <source>tangents</source>
        <translation>касательные</translation>
    </message>
    <message>
        <source>Blender and Godot do not read where leaves are transparent</source>
        <translation>Blender и Godot не читают, где листья прозрачны</translation>
    </message>
    <message>
        <source>all stems and leaves are one mesh</source>
        <translation>все ветви и листья — одна сетка</translation>
    </message>
    <message>
        <source>names end after ten letters; large meshes are cut into parts</source>
        <translation>имена не длиннее десяти букв; большие сетки разрезаны на части</translation>
    </message>
    <message>
        <source>a camera, lights and ground are added</source>
        <translation>добавлены камера, свет и земля</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose no atlas, or level of detail 0 or 1</source>
        <translation>карточки растущего дерева в каждом кадре показывают другую веточку; выберите экспорт без атласа либо уровень детализации 0 или 1</translation>
    </message>
    <message>
        <source>Of glTF and USD files: one mesh for all leaves of a kind and a list of places instead of a copy for each, for programs that know it (EXT_mesh_gpu_instancing, PointInstancer). Normals are not rounded, and each leaf has one tint.</source>
        <translation>Для файлов glTF и USD: одна сетка на все листья вида и список мест вместо копии на каждый — для программ, которые это умеют (EXT_mesh_gpu_instancing, PointInstancer). Нормали не скругляются, у каждого листа один оттенок.</translation>
    </message>
    <message>
        <source>Levels of detail are variants of the set LOD, which three.js does not read: choose a file for each</source>
        <translation>Уровни детализации — варианты набора LOD, которые three.js не читает: выберите по файлу на каждый</translation>
    </message>
    <message>
        <source>%1 cannot hold instances; choose glTF or USD</source>
        <translation>%1 не может содержать экземпляры; выберите glTF или USD</translation>
    </message>
    <message>
        <source>only PNG textures can go into an atlas, not %1</source>
        <translation>в атлас входят только текстуры PNG, не %1</translation>
    </message>
    <message>
        <source>%1 repeats its texture (texture coordinates beyond 0 to 1), which an atlas cannot do</source>
        <translation>%1 повторяет свою текстуру (координаты текстуры вне 0…1), в атласе это невозможно</translation>
    </message>
    <message>
        <source>By branch level</source>
        <translation>По уровням ветвей</translation>
    </message>
    <message>
        <source>By material</source>
        <translation>По материалам</translation>
    </message>
    <message>
        <source>Leaves, blossoms and twigs</source>
        <translation>Листья, цветы и веточки</translation>
    </message>
    <message>
        <source>Separate objects for trunk, branches and leaves, or one object per material: fewer draw calls.</source>
        <translation>Отдельные объекты для ствола, ветвей и листьев или один объект на материал: меньше вызовов отрисовки.</translation>
    </message>
    <message>
        <source>One material and one texture for leaves, blossoms and twigs: fewer draw calls. PNG textures only.</source>
        <translation>Один материал и одна текстура для листьев, цветов и веточек: меньше вызовов отрисовки. Только текстуры PNG.</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no atlas</source>
        <translation>%1 не содержит текстур, поэтому и атласа</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>текстуры</translation>
    </message>
    <message>
        <source>opacity of leaves</source>
        <translation>непрозрачность листьев</translation>
    </message>
    <message>
        <source>normal maps</source>
        <translation>карты нормалей</translation>
    </message>
    <message>
        <source>roughness maps</source>
        <translation>карты шероховатости</translation>
    </message>
    <message>
        <source>leaf tints</source>
        <translation>оттенки листьев</translation>
    </message>
    <message>
        <source>ambient occlusion (attribute)</source>
        <translation>фоновое затенение (атрибут)</translation>
    </message>
    <message>
        <source>the roughness maps lie beside the file</source>
        <translation>карты шероховатости лежат рядом с файлом</translation>
    </message>
    <message>
        <source>frames of a motion have no impostor; choose one tree or none</source>
        <translation>у кадров движения нет импостера; выберите одно дерево или без импостера</translation>
    </message>
    <message>
        <source>Cross of billboards</source>
        <translation>Крест из билбордов</translation>
    </message>
    <message>
        <source>Views from above the horizon (hemi-octahedral)</source>
        <translation>Виды сверху до горизонта (полуоктаэдр)</translation>
    </message>
    <message>
        <source>Views from all sides (octahedral)</source>
        <translation>Виды со всех сторон (октаэдр)</translation>
    </message>
    <message>
        <source>Impostor</source>
        <translation>Импостер</translation>
    </message>
    <message>
        <source>What stands for the tree when it is far: two crossed billboards as the last level of detail, or 8 × 8 views in an atlas beside the model (albedo, normal, depth), for a shader that shows the nearest.</source>
        <translation>Что заменяет дерево вдали: два скрещённых билборда как последний уровень детализации или 8 × 8 видов в атласе рядом с моделью (цвет, нормали, глубина) для шейдера, который показывает ближайшие.</translation>
    </message>
    <message>
        <source>one solid has no impostor</source>
        <translation>у единого тела нет импостера</translation>
    </message>
    <message>
        <source>crossed billboards are the last level of detail; choose all levels of detail</source>
        <translation>скрещённые билборды — последний уровень детализации; выберите все уровни детализации</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no billboards</source>
        <translation>%1 не содержит текстур, а значит и билбордов</translation>
    </message>
    <message>
        <source>a row of trees has no impostor; choose one tree or none</source>
        <translation>у ряда деревьев нет импостера; выберите одно дерево или без импостера</translation>
    </message>
    <message>
        <source>an impostor can be made of PNG textures only, not of %1</source>
        <translation>импостер можно сделать только из текстур PNG, не из %1</translation>
    </message>
    <message>
        <source>Without overlap, for light maps</source>
        <translation>Без наложений, для карт освещения</translation>
    </message>
    <message>
        <source>Second UV</source>
        <translation>Второй UV</translation>
    </message>
    <message>
        <source>A second set of texture coordinates, in which no two triangles share a place: for light maps, in glTF and FBX files.</source>
        <translation>Второй набор текстурных координат, в котором никакие два треугольника не занимают одно место: для карт освещения, в файлах glTF и FBX.</translation>
    </message>
    <message>
        <source>%1 holds one set of texture coordinates; choose glTF or FBX</source>
        <translation>%1 содержит один набор текстурных координат; выберите glTF или FBX</translation>
    </message>
    <message>
        <source>one solid has no texture coordinates</source>
        <translation>у одного тела нет текстурных координат</translation>
    </message>
    <message>
        <source>the second texture coordinates hold the wind already</source>
        <translation>вторые текстурные координаты уже заняты ветром</translation>
    </message>
    <message>
        <source>instances share their texture coordinates</source>
        <translation>экземпляры имеют общие текстурные координаты</translation>
    </message>
    <message>
        <source>instances (PointInstancer), levels of detail in one file (variants) and time samples are for programs that are built on OpenUSD: three.js shows none of them</source>
        <translation>экземпляры (PointInstancer), уровни детализации в одном файле (варианты) и временные выборки — для программ на основе OpenUSD: three.js ничего из этого не показывает</translation>
    </message>
    <message>
        <source>%1 holds no time samples; choose USD</source>
        <translation>%1 не содержит временных выборок; выберите USD</translation>
    </message>
    <message>
        <source>time samples belong to one level of detail; choose a file for each</source>
        <translation>временные выборки относятся к одному уровню детализации; выберите файл для каждого</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose level of detail 0 or 1</source>
        <translation>карточки растущего дерева показывают в каждом кадре другую веточку; выберите уровень детализации 0 или 1</translation>
    </message>
</context>
<context>
    <name>stromar::CComparison</name>
    <message>
        <source>Kept; A shows it in place of what you make of it</source>
        <translation>Запомнено; клавиша A показывает его вместо того, что из него получилось</translation>
    </message>
    <message>
        <source>Nothing was kept yet: Shift+A keeps the tree as it is</source>
        <translation>Ещё ничего не запомнено: Shift+A запоминает дерево таким, какое оно есть</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>До</translation>
    </message>
</context>
<context>
    <name>stromar::CCurveEditor</name>
    <message>
        <source>value</source>
        <translation>значение</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>&amp;Удалить точку</translation>
    </message>
</context>
<context>
    <name>stromar::CDockFolder</name>
    <message>
        <source>Folded docks</source>
        <translation>Свёрнутые панели</translation>
    </message>
</context>
<context>
    <name>stromar::CDocument</name>
    <message>
        <source>new.tree</source>
        <translation>новое.tree</translation>
    </message>
    <message>
        <source>Open preset %1</source>
        <translation>Открыть заготовку %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Восстановить</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Несохранённые изменения</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Импорт %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportController</name>
    <message>
        <source>Writing %1</source>
        <translation>Запись %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Cannot export the tree</source>
        <translation>Не удаётся экспортировать дерево</translation>
    </message>
    <message>
        <source>Export cancelled; no file was changed</source>
        <translation>Экспорт отменён; ни один файл не изменён</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Экспортировано: %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Экспорт</translation>
    </message>
    <message>
        <source>Lost in this format</source>
        <translation>В этом формате теряется</translation>
    </message>
    <message>
        <source>Size, about</source>
        <translation>Размер, около</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Обзор…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Where to export</source>
        <translation>Куда экспортировать</translation>
    </message>
    <message>
        <source>The file&apos;s name has to end in %1</source>
        <translation>Имя файла должно кончаться на %1</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 уже существует. Заменить?</translation>
    </message>
    <message>
        <source>%1, and what displacement adds</source>
        <translation>%1 и то, что добавит смещение поверхности</translation>
    </message>
    <message>
        <source>No program in particular</source>
        <translation>Никакая определённая программа</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Загрузить…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Сохранить…</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Для</translation>
    </message>
    <message>
        <source>Load Export Settings</source>
        <translation>Загрузить настройки экспорта</translation>
    </message>
    <message>
        <source>Export settings (*.export)</source>
        <translation>Настройки экспорта (*.export)</translation>
    </message>
    <message>
        <source>Cannot load the settings</source>
        <translation>Настройки загрузить нельзя</translation>
    </message>
    <message>
        <source>Save Export Settings</source>
        <translation>Сохранить настройки экспорта</translation>
    </message>
    <message>
        <source>Cannot save the settings</source>
        <translation>Настройки сохранить нельзя</translation>
    </message>
    <message>
        <source>This tree alone</source>
        <translation>Только это дерево</translation>
    </message>
    <message>
        <source>All %1 side by side, as one scene</source>
        <translation>Все %1 рядом, одной сценой</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Деревья</translation>
    </message>
</context>
<context>
    <name>stromar::CFallController</name>
    <message>
        <source>Fell the tree</source>
        <translation>Срубить дерево</translation>
    </message>
    <message>
        <source> m</source>
        <translation> м</translation>
    </message>
    <message>
        <source>Where it falls to: 0 to the right, 90 away from the front</source>
        <translation>Куда падает: 0 — вправо, 90 — назад</translation>
    </message>
    <message>
        <source>Of the cut above the ground; 0 fells it with its foot</source>
        <translation>Высота среза над землёй; 0 валит дерево с комлем</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Направление</translation>
    </message>
    <message>
        <source>&amp;Height of the cut</source>
        <translation>&amp;Высота среза</translation>
    </message>
    <message>
        <source>&amp;Fell</source>
        <translation>С&amp;рубить</translation>
    </message>
</context>
<context>
    <name>stromar::CFileController</name>
    <message>
        <source>Trees (*.tree);;All files (*)</source>
        <translation>Деревья (*.tree);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Autosave: %1</source>
        <translation>Автосохранение: %1</translation>
    </message>
    <message>
        <source>Cannot open the tree</source>
        <translation>Не удаётся открыть дерево</translation>
    </message>
    <message>
        <source>Cannot open the preset</source>
        <translation>Не удаётся открыть заготовку</translation>
    </message>
    <message>
        <source>Cannot save the tree</source>
        <translation>Не удаётся сохранить дерево</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <source>Open a tree</source>
        <translation>Открыть дерево</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Сохранить дерево</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Сохранить как заготовку</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Имя заготовки</translation>
    </message>
    <message>
        <source>Replace the preset “%1”?</source>
        <translation>Заменить заготовку «%1»?</translation>
    </message>
    <message>
        <source>Cannot save the preset</source>
        <translation>Не удаётся сохранить заготовку</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)</source>
        <translation>Картинки (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;Все файлы (*)</translation>
    </message>
    <message>
        <source>As the &amp;bark</source>
        <translation>Как &amp;кору</translation>
    </message>
    <message>
        <source>As the &amp;leaf</source>
        <translation>Как &amp;лист</translation>
    </message>
    <message>
        <source>Another program has changed %1. Opening it again loses your changes.</source>
        <translation>Другая программа изменила %1. Если открыть снова, ваши изменения пропадут.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Другая программа изменила %1.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Открыть снова</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Оставить мои</translation>
    </message>
    <message>
        <source>A tree that was never saved</source>
        <translation>Дерево, которое не сохранялось</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Восстановить несохранённые изменения</translation>
    </message>
    <message>
        <source>Stromar ended without saving these changes of %1:
%2</source>
        <translation>Stromar завершился, не сохранив эти изменения от %1:
%2</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Восстановить</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Отбросить</translation>
    </message>
    <message>
        <source>Ask &amp;Later</source>
        <translation>Спросить &amp;позже</translation>
    </message>
    <message>
        <source>Cannot restore</source>
        <translation>Не удаётся восстановить</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Несохранённые изменения</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Сохранить изменения в %1?</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.glb);;All files (*)</source>
        <translation>Сетки (*.obj *.glb);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Changes from before a preset was opened are not saved; Undo brings them back. Go on without them?</source>
        <translation>Изменения, сделанные до открытия заготовки, не сохранены; «Отменить» вернёт их. Продолжить без них?</translation>
    </message>
    <message>
        <source>Cannot open the workshop</source>
        <translation>Мастерскую открыть нельзя</translation>
    </message>
    <message>
        <source>Cannot import the tree</source>
        <translation>Не удалось импортировать дерево</translation>
    </message>
    <message>
        <source>Trees of other programs</source>
        <translation>Деревья других программ</translation>
    </message>
    <message>
        <source>Import a tree</source>
        <translation>Импорт дерева</translation>
    </message>
</context>
<context>
    <name>stromar::CGrowthController</name>
    <message>
        <source>%1 = %2 fits</source>
        <translation>%1 = %2 помещается</translation>
    </message>
    <message>
        <source>Grow it anyway</source>
        <translation>Всё равно вырастить</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Отменить</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>Nothing has grown: this tree may have up to %1 stems, %2 leaves and %3 million vertices and take %4 GB of memory; the limit is %5 million vertices and %6 GB.</source>
        <translation>Ничего не выросло: у этого дерева может быть до %1 ветвей, %2 листьев и %3 миллионов вершин, и оно может занять %4 ГБ памяти; предел — %5 миллионов вершин и %6 ГБ.</translation>
    </message>
</context>
<context>
    <name>stromar::CHelpWindow</name>
    <message>
        <source>Stromar Manual</source>
        <translation>Руководство по Stromar</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Страницы</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Вперёд</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Содержание</translation>
    </message>
</context>
<context>
    <name>stromar::CLanguageEditor</name>
    <message>
        <source>What is wrong</source>
        <translation>Что неверно</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Найти</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Импорт…</translation>
    </message>
    <message>
        <source>Take the text of a file</source>
        <translation>Взять текст из файла</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Экспорт…</translation>
    </message>
    <message>
        <source>Write the text to a file of its own</source>
        <translation>Записать текст в отдельный файл</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Открепить</translation>
    </message>
    <message>
        <source>Show the editor in a window of its own, or back in its tab</source>
        <translation>Показать редактор в отдельном окне или снова на вкладке</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Шаг</translation>
    </message>
    <message>
        <source>The word after this step</source>
        <translation>Слово после этого шага</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> из %1</translation>
    </message>
    <message>
        <source>Import a Text</source>
        <translation>Импорт текста</translation>
    </message>
    <message>
        <source>Cannot import the text</source>
        <translation>Не удалось импортировать текст</translation>
    </message>
    <message>
        <source>Export the Text</source>
        <translation>Экспорт текста</translation>
    </message>
    <message>
        <source>Cannot export the text</source>
        <translation>Не удалось экспортировать текст</translation>
    </message>
    <message>
        <source> … %1 more</source>
        <translation> … ещё %1</translation>
    </message>
    <message>
        <source>line %1 × %2</source>
        <translation>строка %1 × %2</translation>
    </message>
    <message>
        <source>No rule applies to this word.</source>
        <translation>К этому слову не подходит ни одно правило.</translation>
    </message>
    <message>
        <source>To the next: %1</source>
        <translation>К следующему: %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Прикрепить</translation>
    </message>
</context>
<context>
    <name>stromar::CLightPanel</name>
    <message>
        <source>Reset light</source>
        <translation>Сбросить свет</translation>
    </message>
    <message>
        <source>%1 stops</source>
        <translation>%1 ступени</translation>
    </message>
</context>
<context>
    <name>stromar::CMainWindow</name>
    <message>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Заготовки</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Как открыто</translation>
    </message>
    <message>
        <source>History</source>
        <translation>История</translation>
    </message>
    <message>
        <source>Messages of the file</source>
        <translation>Сообщения о файле</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Сообщения</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Инструменты</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Открыть &amp;недавние</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>Перемешать</translation>
    </message>
    <message>
        <source>The graphics driver has started again</source>
        <translation>Графический драйвер перезапустился</translation>
    </message>
    <message>
        <source>Stopped; F6 grows the full model</source>
        <translation>Остановлено; F6 вырастит полную модель</translation>
    </message>
    <message>
        <source>No manual</source>
        <translation>Нет руководства</translation>
    </message>
    <message>
        <source>The pages of the manual are not installed.</source>
        <translation>Страницы руководства не установлены.</translation>
    </message>
    <message>
        <source>About Stromar</source>
        <translation>О программе Stromar</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Grows trees by the model of Weber and Penn, “Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Растит деревья по модели Вебера и Пенна, «Creation and Rendering of Realistic Trees», SIGGRAPH ’95.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Свет</translation>
    </message>
    <message>
        <source>New &amp;Tree by</source>
        <translation>Новое &amp;дерево по методу</translation>
    </message>
    <message>
        <source>The tree is growing; Esc cancels</source>
        <translation>Дерево растёт; Esc — отмена</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>%1   %2   %3 leaves   %4 vertices   %5 triangles   %6 ms</source>
        <translation>%1   %2   %3 листьев   %4 вершин   %5 треугольников   %6 мс</translation>
    </message>
    <message>
        <source>Saved Cameras</source>
        <translation>Сохранённые камеры</translation>
    </message>
    <message>
        <source>Nothing has grown yet</source>
        <translation>Ещё ничего не выросло</translation>
    </message>
    <message>
        <source>No tree was found among these random values; a smaller amount finds some</source>
        <translation>Среди этих случайных значений дерева нет; при меньшем размахе оно найдётся</translation>
    </message>
</context>
<context>
    <name>stromar::CMessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Закрыть</translation>
    </message>
</context>
<context>
    <name>stromar::CParamEditor</name>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Другое дерево того же вида</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Случайное зерно</translation>
    </message>
</context>
<context>
    <name>stromar::CParamPanel</name>
    <message>
        <source>Find a parameter</source>
        <translation>Найти параметр</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Загрузить…</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Выбрать картинку</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Рисовать</translation>
    </message>
    <message>
        <source>A picture that Stromar draws; the words behind its name can be changed</source>
        <translation>Картинка, которую рисует Stromar; слова за именем можно менять</translation>
    </message>
    <message>
        <source>Texture Workshop…</source>
        <translation>Мастерская текстур…</translation>
    </message>
    <message>
        <source>Choose a mesh</source>
        <translation>Выбрать сетку</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Встроенные</translation>
    </message>
    <message>
        <source>A mesh that comes with Stromar</source>
        <translation>Сетка из комплекта Stromar</translation>
    </message>
    <message>
        <source>No parameter is called “%1”.</source>
        <translation>Нет параметра с названием «%1».</translation>
    </message>
    <message>
        <source>Where they point</source>
        <translation>Куда они направлены</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Значения</translation>
    </message>
    <message>
        <source>Copies, pastes and keeps the values of this tab; a right click on a heading does it with what stands below</source>
        <translation>Копирует, вставляет и сохраняет значения этой вкладки; правый щелчок по заголовку делает это с тем, что под ним</translation>
    </message>
</context>
<context>
    <name>stromar::CParamRow</name>
    <message>
        <source>Without effect: %1</source>
        <translation>Не действует: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>По умолчанию %1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Вставить %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Вставить</translation>
    </message>
    <message>
        <source>&amp;Reset to Default</source>
        <translation>По &amp;умолчанию</translation>
    </message>
    <message>
        <source>Back to the &amp;Saved Value</source>
        <translation>К со&amp;хранённому значению</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>&amp;Lock against Randomise</source>
        <translation>&amp;Закрепить от перемешивания</translation>
    </message>
    <message>
        <source>Copy to &amp;Level</source>
        <translation>Копировать на &amp;уровень</translation>
    </message>
</context>
<context>
    <name>stromar::CPictureDialog</name>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Прозрачный фон</translation>
    </message>
    <message>
        <source>Save a Picture</source>
        <translation>Сохранить картинку</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Одна картинка</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> кадров</translation>
    </message>
    <message>
        <source>More than one: the tree turns once around, each frame a numbered PNG file</source>
        <translation>Больше одного: дерево поворачивается один раз, каждый кадр — пронумерованный файл PNG</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ширина</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Высота</translation>
    </message>
    <message>
        <source>T&amp;urntable</source>
        <translation>Вр&amp;ащение</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Картинки (*.png *.jpg)</translation>
    </message>
</context>
<context>
    <name>stromar::CPreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Clear the Picture Cache (%1)</source>
        <translation>Очистить кэш изображений (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CPresetBrowser</name>
    <message>
        <source>Find a tree</source>
        <translation>Найти дерево</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Все</translation>
    </message>
    <message>
        <source>Stromar&apos;s</source>
        <translation>Stromar</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Мои</translation>
    </message>
    <message>
        <source>Folder of presets</source>
        <translation>Папка заготовок</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Сохранить…</translation>
    </message>
    <message>
        <source>Keep the tree in the window as a preset of your own</source>
        <translation>Сохранить дерево из окна как свою заготовку</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Заготовки</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>Автор: %1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Открыть</translation>
    </message>
    <message>
        <source>&amp;Remove…</source>
        <translation>&amp;Удалить…</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Удалить заготовку</translation>
    </message>
    <message>
        <source>Move “%1” to the waste bin?</source>
        <translation>Переместить «%1» в корзину?</translation>
    </message>
    <message>
        <source>%1 cannot be removed.</source>
        <translation>%1 не удаётся удалить.</translation>
    </message>
    <message>
        <source>No presets yet: Save… keeps the tree in the window.</source>
        <translation>Заготовок ещё нет: «Сохранить…» сохранит дерево из окна.</translation>
    </message>
    <message>
        <source>No preset is called “%1”.</source>
        <translation>Нет заготовки с названием «%1».</translation>
    </message>
</context>
<context>
    <name>stromar::CRecordDialog</name>
    <message>
        <source> px</source>
        <translation> пикс.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> с</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Записать</translation>
    </message>
    <message>
        <source>Growth, up to the age that is shown</source>
        <translation>Рост до показанного возраста</translation>
    </message>
    <message>
        <source>Wind, in a loop</source>
        <translation>Ветер по кругу</translation>
    </message>
    <message>
        <source>The fall</source>
        <translation>Падение</translation>
    </message>
    <message>
        <source>Numbered pictures (PNG)</source>
        <translation>Пронумерованные картинки (PNG)</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Что</translation>
    </message>
    <message>
        <source>Wid&amp;th</source>
        <translation>&amp;Ширина</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Высота</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Длительность</translation>
    </message>
    <message>
        <source>&amp;Frames per second</source>
        <translation>&amp;Кадров в секунду</translation>
    </message>
    <message>
        <source>&amp;As</source>
        <translation>&amp;Как</translation>
    </message>
    <message>
        <source>Video (MP4)</source>
        <translation>Видео (MP4)</translation>
    </message>
    <message>
        <source>For videos, install ffmpeg.</source>
        <translation>Для видео установите ffmpeg.</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>Видео (*.mp4)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Картинки (*.png)</translation>
    </message>
</context>
<context>
    <name>stromar::CRecorder</name>
    <message>
        <source>Recording</source>
        <translation>Запись</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Recording cancelled; no file was changed</source>
        <translation>Запись отменена; файлы не изменены</translation>
    </message>
    <message numerus="yes">
        <source>Recording cancelled: %1 of %n frame(s) are saved</source>
        <translation>
            <numerusform>Запись отменена: сохранено %1 из %n кадра</numerusform>
            <numerusform>Запись отменена: сохранено %1 из %n кадров</numerusform>
            <numerusform>Запись отменена: сохранено %1 из %n кадров</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s)</source>
        <translation>
            <numerusform>Сохранён %n кадр</numerusform>
            <numerusform>Сохранено %n кадра</numerusform>
            <numerusform>Сохранено %n кадров</numerusform>
        </translation>
    </message>
    <message>
        <source>Cannot record</source>
        <translation>Не удаётся записать</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удаётся записать %1.</translation>
    </message>
    <message>
        <source>Making the video</source>
        <translation>Создаётся видео</translation>
    </message>
    <message>
        <source>ffmpeg could not make the video. %1</source>
        <translation>ffmpeg не смог создать видео. %1</translation>
    </message>
</context>
<context>
    <name>stromar::CSavedCameras</name>
    <message>
        <source>None yet: Save Camera keeps one</source>
        <translation>Пока нет: сохраняет команда «Сохранить камеру»</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Камера %1</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Сохранить камеру</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Имя вида</translation>
    </message>
    <message>
        <source>There is a view called “%1” already. Replace it?</source>
        <translation>Вид с именем «%1» уже есть. Заменить его?</translation>
    </message>
</context>
<context>
    <name>stromar::CShortcutsDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Мышь и клавиши</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Колесо</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Ближе и дальше</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Щелчок</translation>
    </message>
    <message>
        <source>Show details of the stem or leaf</source>
        <translation>Показать сведения о ветви или листе</translation>
    </message>
    <message>
        <source>Scroll; changes an editor only after a click into it</source>
        <translation>Прокручивает; меняет значение только после щелчка в него</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Finer steps of a slider</source>
        <translation>Мелкие шаги ползунка</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Larger steps of a slider</source>
        <translation>Крупные шаги ползунка</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Двойной щелчок по имени</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>К значению по умолчанию</translation>
    </message>
    <message>
        <source>Right click on a name</source>
        <translation>Правый щелчок по имени</translation>
    </message>
    <message>
        <source>Copy, paste, lock</source>
        <translation>Копировать, вставить, закрепить</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>В картинке</translation>
    </message>
    <message>
        <source>In the parameters</source>
        <translation>В параметрах</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Клавиши</translation>
    </message>
</context>
<context>
    <name>stromar::CSideBySide</name>
    <message>
        <source>Age %1 %</source>
        <translation>Возраст %1 %</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Простая</translation>
    </message>
    <message>
        <source>LOD %1</source>
        <translation>LOD %1</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>Треугольники: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>от %1</translation>
    </message>
</context>
<context>
    <name>stromar::CTextureWorkshop</name>
    <message>
        <source>Texture Workshop</source>
        <translation>Мастерская текстур</translation>
    </message>
    <message>
        <source>Save Pictures…</source>
        <translation>Сохранить картинки…</translation>
    </message>
    <message>
        <source>Save Pictures</source>
        <translation>Сохранить картинки</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Картинки (*.png)</translation>
    </message>
    <message>
        <source>Cannot save the pictures</source>
        <translation>Картинки не удаётся сохранить</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Изображение</translation>
    </message>
</context>
<context>
    <name>stromar::CThumbnails</name>
    <message>
        <source>There is no OpenGL to draw it.</source>
        <translation>Нет OpenGL, чтобы нарисовать.</translation>
    </message>
</context>
<context>
    <name>stromar::CTimeline</name>
    <message>
        <source>A step back</source>
        <translation>Шаг назад</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Проиграть</translation>
    </message>
    <message>
        <source>A step forward</source>
        <translation>Шаг вперёд</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Возраст</translation>
    </message>
    <message>
        <source>How old the tree is, or how far it has fallen</source>
        <translation>Сколько дереву лет или как далеко оно упало</translation>
    </message>
    <message>
        <source>Age %1 %</source>
        <translation>Возраст %1 %</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Скорость</translation>
    </message>
    <message>
        <source>How fast it is played</source>
        <translation>Как быстро проигрывать</translation>
    </message>
    <message>
        <source>Begin anew at the end</source>
        <translation>В конце начинать заново</translation>
    </message>
    <message>
        <source>Save pictures or a video of it</source>
        <translation>Сохранить картинки или видео</translation>
    </message>
    <message>
        <source>Fall %1 s</source>
        <translation>Падение %1 с</translation>
    </message>
</context>
<context>
    <name>stromar::CVariants</name>
    <message>
        <source>&amp;Nine Others</source>
        <translation>&amp;Девять других</translation>
    </message>
    <message>
        <source>Throw nine other seeds</source>
        <translation>Бросить девять других зёрен</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Любимые зёрна</translation>
    </message>
    <message>
        <source>♥ Like</source>
        <translation>♥ Нравится</translation>
    </message>
    <message>
        <source>Keep the seed of the tree in the window in its file</source>
        <translation>Сохранить зерно дерева из окна в его файле</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Всё</translation>
    </message>
    <message>
        <source>&amp;Randomise</source>
        <translation>&amp;Перемешать</translation>
    </message>
    <message>
        <source>Move the values by chance; locked ones stay (right click a parameter to lock it)</source>
        <translation>Случайно сдвигает значения; закреплённые остаются (закрепить — правый щелчок по параметру)</translation>
    </message>
    <message>
        <source>Random values</source>
        <translation>Случайные значения</translation>
    </message>
    <message>
        <source>&amp;At most</source>
        <translation>&amp;Не более</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Зерно %1</translation>
    </message>
    <message>
        <source>Ages</source>
        <translation>Возрасты</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Age %1</source>
        <translation>Возраст %1</translation>
    </message>
    <message>
        <source>The tree at this part of its life</source>
        <translation>Дерево в этой части жизни</translation>
    </message>
    <message>
        <source>Values of</source>
        <translation>Значения</translation>
    </message>
</context>
<context>
    <name>stromar::CViewController</name>
    <message>
        <source>Drag %1</source>
        <translation>Перетаскивание: %1</translation>
    </message>
    <message>
        <source>%1, stem %2 of %3</source>
        <translation>%1, № %2 из %3</translation>
    </message>
    <message>
        <source>Length %1, radius %2</source>
        <translation>Длина %1, радиус %2</translation>
    </message>
    <message>
        <source>On %1, stem %2, at %3</source>
        <translation>На: %1, № %2, на расстоянии %3</translation>
    </message>
    <message numerus="yes">
        <source>Split into %n path(s)</source>
        <translation>
            <numerusform>Делится на %n путь</numerusform>
            <numerusform>Делится на %n пути</numerusform>
            <numerusform>Делится на %n путей</numerusform>
        </translation>
    </message>
    <message>
        <source>Leaf %1 of %2
Length %3, width %4
On %5, stem %6</source>
        <translation>Лист %1 из %2
Длина %3, ширина %4
На: %5, № %6</translation>
    </message>
    <message>
        <source>Height %1, width %2</source>
        <translation>Высота %1, ширина %2</translation>
    </message>
    <message>
        <source>Leaves: %1, %2 triangles</source>
        <translation>Листья: %1, треугольников: %2</translation>
    </message>
    <message>
        <source>Structure %1 ms, mesh %2 ms</source>
        <translation>Структура %1 мс, сетка %2 мс</translation>
    </message>
    <message>
        <source>Writing pictures</source>
        <translation>Запись картинок</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Cannot save the picture</source>
        <translation>Не удаётся сохранить картинку</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 не удаётся записать.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s) of a turntable</source>
        <translation>
            <numerusform>Сохранён %n кадр вращения</numerusform>
            <numerusform>Сохранены %n кадра вращения</numerusform>
            <numerusform>Сохранено %n кадров вращения</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Line %1 wrote %n segment(s)</source>
        <translation>
            <numerusform>Строка %1 написала %n сегмент</numerusform>
            <numerusform>Строка %1 написала %n сегмента</numerusform>
            <numerusform>Строка %1 написала %n сегментов</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This point touches %n branch(es)</source>
        <translation>
            <numerusform>Эта точка влияет на %n ветвь</numerusform>
            <numerusform>Эта точка влияет на %n ветви</numerusform>
            <numerusform>Эта точка влияет на %n ветвей</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture Behind the Tree</source>
        <translation>Изображение за деревом</translation>
    </message>
    <message>
        <source>Pictures and HDRI panoramas (*.png *.jpg *.jpeg *.hdr)</source>
        <translation>Картинки и панорамы HDRI (*.png *.jpg *.jpeg *.hdr)</translation>
    </message>
    <message>
        <source>Cannot show the picture</source>
        <translation>Не удаётся показать изображение</translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles</source>
        <translation>%1: %2, треугольников: %3</translation>
    </message>
    <message>
        <source>%1: %2 triangles, from %3 on</source>
        <translation>%1: треугольников: %2, от %3</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Эталонное изображение</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Изображения (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Height of what the picture shows, from edge to edge (%1)</source>
        <translation>Высота того, что показывает изображение, от края до края (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CViewOverlay</name>
    <message>
        <source>Height %1</source>
        <translation>Высота %1</translation>
    </message>
    <message>
        <source>Before …</source>
        <translation>До…</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>До</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Сейчас</translation>
    </message>
</context>
<context>
    <name>stromar::CViewport</name>
    <message>
        <source>OpenGL 2.1 is needed to show the tree; this display has %1.%2. Files can still be edited and exported.</source>
        <translation>Для показа дерева нужен OpenGL 2.1; на этом дисплее %1.%2. Файлы по-прежнему можно править и экспортировать.</translation>
    </message>
    <message>
        <source>There is no OpenGL on this display, so the tree cannot be shown. Install your graphics driver. Files can still be edited and exported.</source>
        <translation>На этом дисплее нет OpenGL, поэтому дерево показать нельзя. Установите драйвер видеокарты. Файлы по-прежнему можно править и экспортировать.</translation>
    </message>
    <message>
        <source>Picture of the tree</source>
        <translation>Картинка дерева</translation>
    </message>
</context>
<context>
    <name>stromar::CWelcomeCard</name>
    <message>
        <source>Welcome to Stromar.</source>
        <translation>Добро пожаловать в Stromar.</translation>
    </message>
    <message>
        <source>Begin with a tree and change it:</source>
        <translation>Начните с дерева и измените его:</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>All Presets</source>
        <translation>Все заготовки</translation>
    </message>
    <message>
        <source>Open a File…</source>
        <translation>Открыть файл…</translation>
    </message>
    <message>
        <source>New Tree by</source>
        <translation>Новое дерево по методу</translation>
    </message>
</context>
<context>
    <name>stromar::CWindPanel</name>
    <message>
        <source>Breeze</source>
        <translation>Бриз</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>Gale</source>
        <translation>Шторм</translation>
    </message>
    <message>
        <source>S&amp;way in the wind</source>
        <translation>&amp;Качать на ветру</translation>
    </message>
    <message>
        <source>Flexibility: %1</source>
        <translation>Гибкость: %1</translation>
    </message>
</context>
</TS>
