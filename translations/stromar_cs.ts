<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs">
<context>
    <name>ClampingBox</name>
    <message>
        <source>The maximum is %1</source>
        <translation>Maximum je %1</translation>
    </message>
    <message>
        <source>The minimum is %1</source>
        <translation>Minimum je %1</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nový</translation>
    </message>
    <message>
        <source>Start with a plain tree</source>
        <translation>Začít s jednoduchým stromem</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>Open a .tree file</source>
        <translation>Otevřít soubor .tree</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Uložit strom</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Uložit &amp;jako…</translation>
    </message>
    <message>
        <source>Save the tree in another file</source>
        <translation>Uložit strom do jiného souboru</translation>
    </message>
    <message>
        <source>Save as &amp;Preset…</source>
        <translation>Uložit jako &amp;předvolbu…</translation>
    </message>
    <message>
        <source>Keep the tree among your own presets</source>
        <translation>Zařadit strom mezi vlastní předvolby</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportovat…</translation>
    </message>
    <message>
        <source>Write the tree for another program</source>
        <translation>Zapsat strom pro jiný program</translation>
    </message>
    <message>
        <source>Save P&amp;icture…</source>
        <translation>Uložit o&amp;brázek…</translation>
    </message>
    <message>
        <source>A picture of the tree, or the frames of a turntable</source>
        <translation>Obrázek stromu nebo snímky otáčejícího se stromu</translation>
    </message>
    <message>
        <source>Load &amp;Bark Texture…</source>
        <translation>Načíst texturu &amp;kůry…</translation>
    </message>
    <message>
        <source>Choose the picture on the stems</source>
        <translation>Vybrat obrázek na kmeni a větvích</translation>
    </message>
    <message>
        <source>Load &amp;Leaf Texture…</source>
        <translation>Načíst texturu &amp;listu…</translation>
    </message>
    <message>
        <source>Choose the picture on the leaves</source>
        <translation>Vybrat obrázek na listech</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>U&amp;končit</translation>
    </message>
    <message>
        <source>Leave Stromar</source>
        <translation>Opustit Stromar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zpět</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Vzít poslední změnu zpět</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Znovu</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Provést změnu znovu</translation>
    </message>
    <message>
        <source>&amp;Find Parameter</source>
        <translation>&amp;Najít parametr</translation>
    </message>
    <message>
        <source>Look for a parameter by its name</source>
        <translation>Hledat parametr podle názvu</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>Na&amp;stavení…</translation>
    </message>
    <message>
        <source>Theme, language, mouse, units</source>
        <translation>Vzhled, jazyk, myš, jednotky</translation>
    </message>
    <message>
        <source>&amp;Another Seed</source>
        <translation>&amp;Jiné semínko</translation>
    </message>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Jiný strom téhož druhu</translation>
    </message>
    <message>
        <source>&amp;Generate</source>
        <translation>&amp;Vytvořit znovu</translation>
    </message>
    <message>
        <source>Build the tree again from scratch</source>
        <translation>Postavit strom od začátku</translation>
    </message>
    <message>
        <source>&amp;Full Model</source>
        <translation>Úplný &amp;model</translation>
    </message>
    <message>
        <source>Show the full model now</source>
        <translation>Ukázat úplný model hned</translation>
    </message>
    <message>
        <source>&amp;Stop Growing</source>
        <translation>&amp;Zastavit růst</translation>
    </message>
    <message>
        <source>Give up the tree that is growing, and let go of what is selected</source>
        <translation>Vzdát strom, který právě roste, a zrušit výběr</translation>
    </message>
    <message>
        <source>&amp;Recentre</source>
        <translation>&amp;Vystředit</translation>
    </message>
    <message>
        <source>See the whole tree from the front</source>
        <translation>Vidět celý strom zepředu</translation>
    </message>
    <message>
        <source>&amp;Frame the Tree</source>
        <translation>Celý &amp;strom</translation>
    </message>
    <message>
        <source>See the whole tree from where you are</source>
        <translation>Vidět celý strom odtud, odkud se díváte</translation>
    </message>
    <message>
        <source>From the Fr&amp;ont</source>
        <translation>Z&amp;epředu</translation>
    </message>
    <message>
        <source>Look along the Y axis</source>
        <translation>Pohled podél osy Y</translation>
    </message>
    <message>
        <source>Look along the X axis</source>
        <translation>Pohled podél osy X</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>S&amp;hora</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Pohled dolů</translation>
    </message>
    <message>
        <source>Ort&amp;hographic</source>
        <translation>&amp;Rovnoběžné promítání</translation>
    </message>
    <message>
        <source>Without perspective</source>
        <translation>Bez perspektivy</translation>
    </message>
    <message>
        <source>Turn &amp;Freely</source>
        <translation>Otáčet &amp;volně</translation>
    </message>
    <message>
        <source>Roll the tree in all directions instead of keeping it upright</source>
        <translation>Otáčet strom všemi směry místo jen svisle</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drátěný</translation>
    </message>
    <message>
        <source>Show the wireframe</source>
        <translation>Ukázat drátěný model</translation>
    </message>
    <message>
        <source>Show the wireframe on the shaded tree</source>
        <translation>Ukázat drátěný model na vystínovaném stromu</translation>
    </message>
    <message>
        <source>&amp;Bare</source>
        <translation>&amp;Holý</translation>
    </message>
    <message>
        <source>Hide the leaves</source>
        <translation>Skrýt listy</translation>
    </message>
    <message>
        <source>&amp;Grid and Person</source>
        <translation>&amp;Mřížka a postava</translation>
    </message>
    <message>
        <source>Show a grid of metres and a person beside the tree</source>
        <translation>Ukázat metrovou mřížku a postavu vedle stromu</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>&amp;Statistika</translation>
    </message>
    <message>
        <source>Show sizes and counts in the picture</source>
        <translation>Ukázat v obrázku rozměry a počty</translation>
    </message>
    <message>
        <source>S&amp;ky</source>
        <translation>O&amp;bloha</translation>
    </message>
    <message>
        <source>Sky and ground behind the tree</source>
        <translation>Obloha a zem za stromem</translation>
    </message>
    <message>
        <source>&amp;Light Grey</source>
        <translation>S&amp;větle šedá</translation>
    </message>
    <message>
        <source>A light, plain backdrop</source>
        <translation>Světlé jednolité pozadí</translation>
    </message>
    <message>
        <source>&amp;Dark Grey</source>
        <translation>&amp;Tmavě šedá</translation>
    </message>
    <message>
        <source>A dark, plain backdrop</source>
        <translation>Tmavé jednolité pozadí</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Obnovit rozložení</translation>
    </message>
    <message>
        <source>Put all docks back to where they were at first</source>
        <translation>Vrátit všechny panely tam, kde byly na začátku</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Příručka</translation>
    </message>
    <message>
        <source>Read how Stromar works</source>
        <translation>Přečíst si, jak Stromar pracuje</translation>
    </message>
    <message>
        <source>Mouse and &amp;Keys</source>
        <translation>Myš a &amp;klávesy</translation>
    </message>
    <message>
        <source>How to move about, and all shortcuts</source>
        <translation>Jak se pohybovat a všechny zkratky</translation>
    </message>
    <message>
        <source>&amp;About Stromar</source>
        <translation>&amp;O programu Stromar</translation>
    </message>
    <message>
        <source>Version and origin</source>
        <translation>Verze a původ</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Úp&amp;ravy</translation>
    </message>
    <message>
        <source>&amp;Tree</source>
        <translation>S&amp;trom</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Zobrazení</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Okno</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Nápověda</translation>
    </message>
    <message>
        <source>&amp;Lit</source>
        <translation>&amp;Osvětleně</translation>
    </message>
    <message>
        <source>The tree in the light</source>
        <translation>Strom ve světle</translation>
    </message>
    <message>
        <source>&amp;Material Alone</source>
        <translation>Jen &amp;materiál</translation>
    </message>
    <message>
        <source>The pictures without light</source>
        <translation>Obrázky bez světla</translation>
    </message>
    <message>
        <source>O&amp;cclusion Alone</source>
        <translation>Jen &amp;zastínění</translation>
    </message>
    <message>
        <source>How much of the sky each place sees</source>
        <translation>Kolik oblohy které místo vidí</translation>
    </message>
    <message>
        <source>&amp;Normals Alone</source>
        <translation>Jen &amp;normály</translation>
    </message>
    <message>
        <source>Where each place faces, as a colour</source>
        <translation>Kam které místo míří, jako barva</translation>
    </message>
    <message>
        <source>Wireframe &amp;over the Tree</source>
        <translation>Dráty &amp;přes strom</translation>
    </message>
    <message>
        <source>&amp;Record…</source>
        <translation>&amp;Nahrát…</translation>
    </message>
    <message>
        <source>Pictures or a video of the tree as it grows or sways</source>
        <translation>Obrázky nebo video stromu, který roste nebo se kymácí</translation>
    </message>
    <message>
        <source>&amp;Play Growth</source>
        <translation>&amp;Přehrát růst</translation>
    </message>
    <message>
        <source>Let the tree grow from its first day</source>
        <translation>Nechat strom růst od prvního dne</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>V&amp;ítr</translation>
    </message>
    <message>
        <source>Let the tree sway in the wind</source>
        <translation>Nechat strom kymácet ve větru</translation>
    </message>
    <message>
        <source>F&amp;ell…</source>
        <translation>Po&amp;kácet…</translation>
    </message>
    <message>
        <source>Cut the tree and let it fall; the timeline runs over its fall</source>
        <translation>Pokácet strom; časová osa pak vede jeho pádem</translation>
    </message>
    <message>
        <source>&amp;Picture or Panorama…</source>
        <translation>&amp;Obrázek nebo panorama…</translation>
    </message>
    <message>
        <source>Tint What Is &amp;Edited</source>
        <translation>Zabarvit, co se &amp;upravuje</translation>
    </message>
    <message>
        <source>Keep the tint of what the value in hand changes; else it only flashes</source>
        <translation>Ponechat zabarvené, co mění vybraná hodnota; jinak jen problikne</translation>
    </message>
    <message>
        <source>A photograph, or an HDRI panorama that lights the tree</source>
        <translation>Fotografie nebo panorama HDRI, které strom osvětluje</translation>
    </message>
    <message>
        <source>Level of Detail &amp;0</source>
        <translation>Úroveň detailu &amp;0</translation>
    </message>
    <message>
        <source>The full model, for near views</source>
        <translation>Úplný model, pro pohledy zblízka</translation>
    </message>
    <message>
        <source>Level of Detail &amp;1</source>
        <translation>Úroveň detailu &amp;1</translation>
    </message>
    <message>
        <source>The full model as it is seen from some way off</source>
        <translation>Úplný model, jak je vidět z určité vzdálenosti</translation>
    </message>
    <message>
        <source>Level of Detail &amp;2</source>
        <translation>Úroveň detailu &amp;2</translation>
    </message>
    <message>
        <source>The full model from afar, with cards of whole twigs</source>
        <translation>Úplný model z dálky, s kartami celých větviček</translation>
    </message>
    <message>
        <source>Level of Detail &amp;3</source>
        <translation>Úroveň detailu &amp;3</translation>
    </message>
    <message>
        <source>The coarsest full model, for trees on the horizon</source>
        <translation>Nejhrubší úplný model, pro stromy na obzoru</translation>
    </message>
    <message>
        <source>At Its Distance</source>
        <translation>V její vzdálenosti</translation>
    </message>
    <message>
        <source>Move to where a program would begin to show this level of detail</source>
        <translation>Přejít tam, kde by program začal ukazovat tuto úroveň detailu</translation>
    </message>
    <message>
        <source>From the Back</source>
        <translation>Zezadu</translation>
    </message>
    <message>
        <source>From the Right</source>
        <translation>Zprava</translation>
    </message>
    <message>
        <source>From the Left</source>
        <translation>Zleva</translation>
    </message>
    <message>
        <source>From Below</source>
        <translation>Zdola</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Pohled vzhůru</translation>
    </message>
    <message>
        <source>Save Camera…</source>
        <translation>Uložit kameru…</translation>
    </message>
    <message>
        <source>Keep this view of the tree under a name</source>
        <translation>Uchová tento pohled na strom pod jménem</translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation>Pravítko</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure</source>
        <translation>Tažením z místa na místo změříte vzdálenost</translation>
    </message>
    <message>
        <source>Reference Picture…</source>
        <translation>Referenční obrázek…</translation>
    </message>
    <message>
        <source>A picture of a real tree, in its true size, behind the one in the window</source>
        <translation>Obrázek skutečného stromu ve skutečné velikosti za stromem v okně</translation>
    </message>
    <message>
        <source>Keep as “Before”</source>
        <translation>Uchovat jako „předtím“</translation>
    </message>
    <message>
        <source>Keep the tree as it is now, to compare with what you make of it</source>
        <translation>Uchová strom, jaký je teď, k porovnání s tím, co z něj uděláte</translation>
    </message>
    <message>
        <source>Show “Before”</source>
        <translation>Ukázat „předtím“</translation>
    </message>
    <message>
        <source>The tree as it was kept, until this is switched off or a value changes</source>
        <translation>Uchovaný strom, dokud se to nevypne nebo se nezmění hodnota</translation>
    </message>
    <message>
        <source>One Tree</source>
        <translation>Jeden strom</translation>
    </message>
    <message>
        <source>The tree alone</source>
        <translation>Samotný strom</translation>
    </message>
    <message>
        <source>Nine Seeds Side by Side</source>
        <translation>Devět semínek vedle sebe</translation>
    </message>
    <message>
        <source>The tree among eight others of its kind</source>
        <translation>Strom mezi osmi dalšími svého druhu</translation>
    </message>
    <message>
        <source>Five Ages Side by Side</source>
        <translation>Pět stáří vedle sebe</translation>
    </message>
    <message>
        <source>The tree from its youth to its full age</source>
        <translation>Strom od mládí do plného stáří</translation>
    </message>
    <message>
        <source>Four Seasons Side by Side</source>
        <translation>Čtyři roční období vedle sebe</translation>
    </message>
    <message>
        <source>The tree in winter, spring, summer and autumn</source>
        <translation>Strom v zimě, na jaře, v létě a na podzim</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Vítejte</translation>
    </message>
    <message>
        <source>The ways to begin, as at the first start</source>
        <translation>Způsoby, jak začít, jako při prvním spuštění</translation>
    </message>
    <message>
        <source>Look along the negative Y axis</source>
        <translation>Pohled proti směru osy Y</translation>
    </message>
    <message>
        <source>Look along the negative X axis</source>
        <translation>Pohled proti směru osy X</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>I&amp;mportovat…</translation>
    </message>
    <message>
        <source>Read a tree of Arbaro, Sapling or tree-gen</source>
        <translation>Načíst strom z programu Arbaro, Sapling nebo tree-gen</translation>
    </message>
    <message>
        <source>Simple Model</source>
        <translation>Jednoduchý model</translation>
    </message>
    <message>
        <source>The model that follows a slider, instead of the full one</source>
        <translation>Model, který sleduje posuvník, místo úplného</translation>
    </message>
    <message>
        <source>Wipe between “Before” and Now</source>
        <translation>Předěl mezi „předtím“ a teď</translation>
    </message>
    <message>
        <source>Both trees with a line between them, which can be dragged</source>
        <translation>Oba stromy a mezi nimi čára, kterou lze táhnout</translation>
    </message>
    <message>
        <source>Levels of Detail Side by Side</source>
        <translation>Úrovně detailu vedle sebe</translation>
    </message>
    <message>
        <source>The four levels of detail and the simple model, with their triangles</source>
        <translation>Čtyři úrovně detailu a jednoduchý model s počty trojúhelníků</translation>
    </message>
    <message>
        <source>Look From</source>
        <translation>Směr pohledu</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Pozadí</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Stínování</translation>
    </message>
    <message>
        <source>Level of Detail</source>
        <translation>Úroveň detailu</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porovnat</translation>
    </message>
    <message>
        <source>Side by Side</source>
        <translation>Vedle sebe</translation>
    </message>
</context>
<context>
    <name>Counts</name>
    <message>
        <source>1 stem</source>
        <translation>1 větev</translation>
    </message>
    <message>
        <source>%1 stems</source>
        <translation>%1 větví</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Jednoduchý model</translation>
    </message>
    <message>
        <source>Full model</source>
        <translation>Úplný model</translation>
    </message>
    <message>
        <source>Level of detail %1</source>
        <translation>Úroveň detailu %1</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>Cannot use the values</source>
        <translation>Hodnoty nelze použít</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Vložit %1</translation>
    </message>
    <message>
        <source>Save Values</source>
        <translation>Uložit hodnoty</translation>
    </message>
    <message>
        <source>Name of these values</source>
        <translation>Jméno těchto hodnot</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odstranit</translation>
    </message>
    <message>
        <source>&amp;Copy Values</source>
        <translation>&amp;Kopírovat hodnoty</translation>
    </message>
    <message>
        <source>&amp;Paste Values</source>
        <translation>&amp;Vložit hodnoty</translation>
    </message>
    <message>
        <source>&amp;Save Values…</source>
        <translation>&amp;Uložit hodnoty…</translation>
    </message>
    <message>
        <source>There is no value for %1 among these lines.</source>
        <translation>Mezi těmito řádky není žádná hodnota pro %1.</translation>
    </message>
    <message>
        <source>There are values called “%1” already. Replace them?</source>
        <translation>Hodnoty s názvem „%1“ už existují. Nahradit je?</translation>
    </message>
</context>
<context>
    <name>stromar</name>
    <message>
        <source>Full model</source>
        <translation>Úplný model</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Jednoduchý model</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Ne</translation>
    </message>
    <message>
        <source>In one file</source>
        <translation>V jednom souboru</translation>
    </message>
    <message>
        <source>A file for each</source>
        <translation>Každá ve vlastním souboru</translation>
    </message>
    <message>
        <source>As usual in the format</source>
        <translation>Jak je ve formátu zvykem</translation>
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
        <translation>Uvnitř souboru</translation>
    </message>
    <message>
        <source>Copies beside it</source>
        <translation>Kopie vedle něj</translation>
    </message>
    <message>
        <source>Where they are</source>
        <translation>Kde jsou</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Which model: the full one, or the simple one of the preview.</source>
        <translation>Který model: úplný, nebo jednoduchý z náhledu.</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Úroveň detailu</translation>
    </message>
    <message>
        <source>All levels of detail</source>
        <translation>Všechny úrovně detailu</translation>
    </message>
    <message>
        <source>All four levels of detail: inside one file, or a file for each, named after it.</source>
        <translation>Všechny čtyři úrovně detailu: uvnitř jednoho souboru, nebo každá ve vlastním, pojmenovaném podle ní.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>The model&apos;s metres are multiplied by this: 100 writes centimetres.</source>
        <translation>Metry modelu se násobí tímto číslem: 100 zapíše centimetry.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Svislá osa</translation>
    </message>
    <message>
        <source>Which axis points up. &apos;format&apos; takes what programs expect of the format.</source>
        <translation>Která osa míří nahoru. „format“ vezme to, co programy od formátu čekají.</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Textury</translation>
    </message>
    <message>
        <source>Pictures inside the file, as copies beside it, or where they lie now. &apos;format&apos; takes what is usual.</source>
        <translation>Obrázky uvnitř souboru, jako kopie vedle něj, nebo tam, kde leží teď. „format“ vezme to obvyklé.</translation>
    </message>
    <message>
        <source>%1 cannot hold levels of detail; choose a file for each</source>
        <translation>%1 neumí úrovně detailu; zvolte pro každou vlastní soubor</translation>
    </message>
    <message>
        <source>levels of detail belong to the full model; the simple model has none</source>
        <translation>úrovně detailu patří k úplnému modelu; jednoduchý je nemá</translation>
    </message>
    <message>
        <source>in %1 files y is always up</source>
        <translation>v souborech %1 míří vždy nahoru y</translation>
    </message>
    <message>
        <source>in %1 files z is always up</source>
        <translation>v souborech %1 míří vždy nahoru z</translation>
    </message>
    <message>
        <source>%1 cannot hold pictures; choose copies</source>
        <translation>%1 neumí obrázky; zvolte kopie</translation>
    </message>
    <message>
        <source>glTF, one file</source>
        <translation>glTF, jeden soubor</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>glTF, with its buffer and pictures beside it</source>
        <translation>glTF, data a obrázky vedle něj</translation>
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
        <translation>Stanford PLY, binární</translation>
    </message>
    <message>
        <source>STL, binary</source>
        <translation>STL, binární</translation>
    </message>
    <message>
        <source>3D Studio</source>
        <translation>3D Studio</translation>
    </message>
    <message>
        <source>LightWave object</source>
        <translation>Objekt LightWave</translation>
    </message>
    <message>
        <source>POV-Ray scene</source>
        <translation>Scéna POV-Ray</translation>
    </message>
    <message>
        <source>OpenSceneGraph binary</source>
        <translation>OpenSceneGraph, binární</translation>
    </message>
    <message>
        <source>OpenSceneGraph text</source>
        <translation>OpenSceneGraph, textový</translation>
    </message>
    <message>
        <source>OpenSceneGraph, old text form</source>
        <translation>OpenSceneGraph, starý textový tvar</translation>
    </message>
    <message>
        <source>Width and widest place</source>
        <translation>Šířka a nejširší místo</translation>
    </message>
    <message>
        <source>Curve above</source>
        <translation>Křivka nahoře</translation>
    </message>
    <message>
        <source>Curve below</source>
        <translation>Křivka dole</translation>
    </message>
    <message>
        <source>Bare trunk</source>
        <translation>Holý kmen</translation>
    </message>
    <message>
        <source>Length of the branches</source>
        <translation>Délka větví</translation>
    </message>
    <message>
        <source>Stromar: left turns, right zooms, middle moves</source>
        <translation>Stromar: levé otáčí, pravé přibližuje, prostřední posouvá</translation>
    </message>
    <message>
        <source>Blender: middle button with Shift and Ctrl</source>
        <translation>Blender: prostřední tlačítko se Shift a Ctrl</translation>
    </message>
    <message>
        <source>Maya: all buttons with Alt</source>
        <translation>Maya: všechna tlačítka s Alt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>levým</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>prostředním</translation>
    </message>
    <message>
        <source>right</source>
        <translation>pravým</translation>
    </message>
    <message>
        <source>%1 drag</source>
        <translation>Tažení %1 tlačítkem</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Otáčení</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Posun</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Blíž a dál</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Podle systému</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Světlý</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Tmavý</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metry</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Stopy</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Vzhled</translation>
    </message>
    <message>
        <source>Light or dark windows.</source>
        <translation>Světlá nebo tmavá okna.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Jazyk</translation>
    </message>
    <message>
        <source>The language of menus, parameters and help.</source>
        <translation>Jazyk nabídek, parametrů a nápovědy.</translation>
    </message>
    <message>
        <source>Mouse in the picture</source>
        <translation>Myš v obrázku</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom. The wheel always zooms.</source>
        <translation>Která tlačítka otáčejí, posouvají a přibližují. Kolečko přibližuje vždy.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Délky v</translation>
    </message>
    <message>
        <source>The unit of lengths in the window. Files are always in metres.</source>
        <translation>Jednotka délek v okně. Soubory jsou vždy v metrech.</translation>
    </message>
    <message>
        <source>Full model after</source>
        <translation>Úplný model za</translation>
    </message>
    <message>
        <source>How long the hand rests before the full model follows the simple one.</source>
        <translation>Jak dlouho musí ruka odpočívat, než po jednoduchém modelu přijde úplný.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Vlákna</translation>
    </message>
    <message>
        <source>How many processors grow the tree; 0 takes all.</source>
        <translation>Kolik procesorů pěstuje strom; 0 vezme všechny.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>Průběžně ukládat po</translation>
    </message>
    <message>
        <source>How often changes are kept aside against a crash; 0 never.</source>
        <translation>Jak často se změny odkládají pro případ pádu; 0 nikdy.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>conical</source>
        <translation>kuželová</translation>
    </message>
    <message>
        <source>spherical</source>
        <translation>kulová</translation>
    </message>
    <message>
        <source>hemispherical</source>
        <translation>polokulová</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>válcová</translation>
    </message>
    <message>
        <source>tapered-cylindrical</source>
        <translation>zúžená válcová</translation>
    </message>
    <message>
        <source>flame</source>
        <translation>plamen</translation>
    </message>
    <message>
        <source>inverse-conical</source>
        <translation>obrácený kužel</translation>
    </message>
    <message>
        <source>tend-flame</source>
        <translation>mírný plamen</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>obálka</translation>
    </message>
    <message>
        <source>oval</source>
        <translation>oválný</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>trojúhelník</translation>
    </message>
    <message>
        <source>three-lobe-oak</source>
        <translation>trojlaločný dubový</translation>
    </message>
    <message>
        <source>three-lobe-maple</source>
        <translation>trojlaločný javorový</translation>
    </message>
    <message>
        <source>five-lobe-maple</source>
        <translation>pětilaločný javorový</translation>
    </message>
    <message>
        <source>three-leaflets</source>
        <translation>tři lístky</translation>
    </message>
    <message>
        <source>square</source>
        <translation>čtverec</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>jehlice</translation>
    </message>
    <message>
        <source>card</source>
        <translation>karta</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>obrys</translation>
    </message>
    <message>
        <source>off</source>
        <translation>vypnuto</translation>
    </message>
    <message>
        <source>on</source>
        <translation>zapnuto</translation>
    </message>
    <message>
        <source>The tree is a bare trunk: Levels of stems is 1.</source>
        <translation>Strom je holý kmen: počet úrovní je 1.</translation>
    </message>
    <message>
        <source>It acts on stems of level 2 and deeper, and there are none.</source>
        <translation>Působí na větve úrovně 2 a hlubší, a žádné tu nejsou.</translation>
    </message>
    <message>
        <source>The trunk has no lobes.</source>
        <translation>Kmen nemá laloky.</translation>
    </message>
    <message>
        <source>The trunk has no lobes, or they have no depth.</source>
        <translation>Kmen nemá laloky, nebo nemají hloubku.</translation>
    </message>
    <message>
        <source>The trunk has only one segment, so there is no joint to split at.</source>
        <translation>Kmen má jen jeden díl, není kde se dělit.</translation>
    </message>
    <message>
        <source>These stems never split.</source>
        <translation>Tyto větve se nikdy nedělí.</translation>
    </message>
    <message>
        <source>Nothing in this tree splits.</source>
        <translation>V tomto stromu se nic nedělí.</translation>
    </message>
    <message>
        <source>A card shows what its texture shows: set Form to outline.</source>
        <translation>Karta ukazuje svou texturu: nastavte tvar listu na obrys.</translation>
    </message>
    <message>
        <source>Nothing is pruned: Strength is 0.</source>
        <translation>Nic se neprořezává: síla je 0.</translation>
    </message>
    <message>
        <source>Nothing is pruned, and the crown shape is not the envelope.</source>
        <translation>Nic se neprořezává a tvar koruny není obálka.</translation>
    </message>
    <message>
        <source>Crown shape</source>
        <translation>Tvar koruny</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Koruna</translation>
    </message>
    <message>
        <source>The outline of the crown: how long the branches are from its bottom to its top. &apos;envelope&apos; takes the outline of the pruning tab.</source>
        <translation>Obrys koruny: jak dlouhé jsou větve odspodu nahoru. „obálka“ vezme obrys z karty prořezávání.</translation>
    </message>
    <message>
        <source>The part of the tree&apos;s height, from the ground, that bears no branches.</source>
        <translation>Část výšky stromu od země, která nenese větve.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>The height of the tree.</source>
        <translation>Výška stromu.</translation>
    </message>
    <message>
        <source>Height variation</source>
        <translation>Odchylka výšky</translation>
    </message>
    <message>
        <source>How much taller or smaller a tree of another seed may be.</source>
        <translation>O kolik vyšší nebo nižší může být strom s jiným semínkem.</translation>
    </message>
    <message>
        <source>Z scale</source>
        <translation>Měřítko Z</translation>
    </message>
    <message>
        <source>Printed in the paper&apos;s tables but used by none of its formulas. Kept in files, without effect.</source>
        <translation>Je v tabulkách článku, ale žádný jeho vzorec ho nepoužívá. Zůstává v souborech, bez účinku.</translation>
    </message>
    <message>
        <source>Z scale variation</source>
        <translation>Odchylka měřítka Z</translation>
    </message>
    <message>
        <source>Levels of stems</source>
        <translation>Úrovně větvení</translation>
    </message>
    <message>
        <source>1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level.</source>
        <translation>1 vypěstuje holý kmen, 2 přidá větve, 3 větve na větvích. Listy sedí na poslední úrovni.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tloušťka</translation>
    </message>
    <message>
        <source>The radius of the trunk divided by its length.</source>
        <translation>Poloměr kmene dělený jeho délkou.</translation>
    </message>
    <message>
        <source>Thinning</source>
        <translation>Tenčení</translation>
    </message>
    <message>
        <source>How much thinner than its parent a shorter branch is. Higher values make finer branches.</source>
        <translation>Oč je kratší větev tenčí než její rodič. Vyšší hodnoty dělají jemnější větve.</translation>
    </message>
    <message>
        <source>No stem is drawn thinner than this, so that fine twigs stay visible.</source>
        <translation>Nic se nekreslí tenčí, aby jemné větvičky zůstaly vidět.</translation>
    </message>
    <message>
        <source>Attraction up</source>
        <translation>Vzpřimování</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Růst</translation>
    </message>
    <message>
        <source>How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang.</source>
        <translation>Jak silně se větve úrovně 2 a hlubší ohýbají vzhůru ke světlu. Záporné hodnoty je nechají viset.</translation>
    </message>
    <message>
        <source>Halve splitting</source>
        <translation>Půlit dělení</translation>
    </message>
    <message>
        <source>On: a stem that has split, and its clones, split half as often from then on.</source>
        <translation>Zapnuto: větev, která se rozdělila, a její klony se pak dělí o polovinu méně.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>Every seed gives another tree of the same kind. The same seed always grows the same tree.</source>
        <translation>Každé semínko dá jiný strom téhož druhu. Stejné semínko vypěstuje vždy stejný strom.</translation>
    </message>
    <message>
        <source>Radius factor</source>
        <translation>Násobek poloměru</translation>
    </message>
    <message>
        <source>Makes the trunk thicker or thinner than Thickness says, and the branches with it.</source>
        <translation>Dělá kmen silnější nebo slabší, než říká tloušťka, a větve s ním.</translation>
    </message>
    <message>
        <source>Radius factor variation</source>
        <translation>Odchylka násobku poloměru</translation>
    </message>
    <message>
        <source>How much the radius factor differs from seed to seed.</source>
        <translation>Jak se násobek poloměru liší semínko od semínka.</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Kořenový náběh</translation>
    </message>
    <message>
        <source>How much the trunk widens at the ground. 1 makes it twice as thick there.</source>
        <translation>Oč se kmen u země rozšiřuje. 1 ho tam dělá dvakrát silnějším.</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Laloky</translation>
    </message>
    <message>
        <source>The number of bulges around the trunk. Odd numbers look natural, even ones symmetric.</source>
        <translation>Počet vypuklin kolem kmene. Lichá čísla vypadají přirozeně, sudá souměrně.</translation>
    </message>
    <message>
        <source>Lobe depth</source>
        <translation>Hloubka laloků</translation>
    </message>
    <message>
        <source>How far the bulges stand out, as a part of the radius.</source>
        <translation>Jak daleko vypukliny vystupují, jako část poloměru.</translation>
    </message>
    <message>
        <source>Lobes fade</source>
        <translation>Slábnutí laloků</translation>
    </message>
    <message>
        <source>1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk.</source>
        <translation>1 nechá laloky skončit kousek nad zemí, 0 je vede po celém kmeni.</translation>
    </message>
    <message>
        <source>Splits at the base</source>
        <translation>Dělení u paty</translation>
    </message>
    <message>
        <source>Splitting</source>
        <translation>Dělení</translation>
    </message>
    <message>
        <source>So many more trunks grow out of the end of the trunk&apos;s first segment.</source>
        <translation>Tolik dalších kmenů vyroste z konce prvního dílu kmene.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Počet</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Rozmístění</translation>
    </message>
    <message>
        <source>The most branches of this level that one parent can bear.</source>
        <translation>Nejvíc větví této úrovně, kolik jich může jeden rodič nést.</translation>
    </message>
    <message>
        <source>Spread along segments</source>
        <translation>Rozprostření po dílech</translation>
    </message>
    <message>
        <source>1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls.</source>
        <translation>1 rozmístí větve rovnoměrně, 0 je shromáždí na dolním konci každého dílu rodiče jako přesleny.</translation>
    </message>
    <message>
        <source>Place variation</source>
        <translation>Odchylka místa</translation>
    </message>
    <message>
        <source>How far each branch is moved along its parent, as a part of the spacing.</source>
        <translation>Jak daleko se každá větev posune podél rodiče, jako část rozestupu.</translation>
    </message>
    <message>
        <source>Down angle</source>
        <translation>Úhel odklonu</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Směr</translation>
    </message>
    <message>
        <source>The angle between a branch and its parent. 90 stands off at a right angle.</source>
        <translation>Úhel mezi větví a jejím rodičem. 90 odstává kolmo.</translation>
    </message>
    <message>
        <source>Down angle variation</source>
        <translation>Odchylka úhlu odklonu</translation>
    </message>
    <message>
        <source>How much the down angle differs from branch to branch. Negative values are not random: they grade the angle along the parent, more at its base, less at its tip.</source>
        <translation>Jak se úhel odklonu liší větev od větve. Záporné hodnoty nejsou náhodné: odstupňují úhel podél rodiče, víc u paty, méně u špičky.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Otočení</translation>
    </message>
    <message>
        <source>The turn about the parent from one branch to the next. Negative values put the branches on alternate sides.</source>
        <translation>Otočení kolem rodiče od jedné větve ke druhé. Záporné hodnoty kladou větve střídavě na obě strany.</translation>
    </message>
    <message>
        <source>Rotation variation</source>
        <translation>Odchylka otočení</translation>
    </message>
    <message>
        <source>How much the rotation differs from branch to branch.</source>
        <translation>Jak se otočení liší větev od větve.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <source>The length as a part of the parent&apos;s length; for the trunk, of the tree&apos;s height.</source>
        <translation>Délka jako část délky rodiče; u kmene výšky stromu.</translation>
    </message>
    <message>
        <source>Length variation</source>
        <translation>Odchylka délky</translation>
    </message>
    <message>
        <source>How much the length differs from stem to stem.</source>
        <translation>Jak se délka liší větev od větve.</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Sbíhavost</translation>
    </message>
    <message>
        <source>The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres.</source>
        <translation>Tvar dřeva: 0 válec, 1 kužel, 2 válec s kulatým koncem, 3 řada koulí.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Díly</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Zakřivení</translation>
    </message>
    <message>
        <source>The number of segments a stem consists of. More segments bend and split more finely.</source>
        <translation>Z kolika dílů se větev skládá. Více dílů se ohýbá a dělí jemněji.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Ohyb</translation>
    </message>
    <message>
        <source>How much the stem bends from base to tip. Positive values bend down, negative ones up.</source>
        <translation>Oč se větev ohne od paty ke špičce. Kladné hodnoty ohýbají dolů, záporné nahoru.</translation>
    </message>
    <message>
        <source>Curve back</source>
        <translation>Zpětný ohyb</translation>
    </message>
    <message>
        <source>Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems.</source>
        <translation>Není-li 0, ohýbá se dolní polovina podle ohybu a horní podle této hodnoty: větve tvaru S.</translation>
    </message>
    <message>
        <source>Curve variation</source>
        <translation>Odchylka ohybu</translation>
    </message>
    <message>
        <source>Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle.</source>
        <translation>Náhodné ohýbání rozdělené na díly. Záporné hodnoty stáčejí větev do šroubovice o tomto úhlu.</translation>
    </message>
    <message>
        <source>Splits per segment</source>
        <translation>Dělení na díl</translation>
    </message>
    <message>
        <source>How many clones split off at the end of each segment, on average. 1 forks at every one.</source>
        <translation>Kolik klonů se odštěpí na konci každého dílu, v průměru. 1 se rozdvojí na každém.</translation>
    </message>
    <message>
        <source>Split angle</source>
        <translation>Úhel dělení</translation>
    </message>
    <message>
        <source>How far each part leans away from the vertical after a split. Towards its tip it turns back again.</source>
        <translation>Jak daleko se každá část po rozdělení odkloní od svislice. Ke špičce se zase vrací.</translation>
    </message>
    <message>
        <source>Split angle variation</source>
        <translation>Odchylka úhlu dělení</translation>
    </message>
    <message>
        <source>How much the split angle differs from fork to fork.</source>
        <translation>Jak se úhel dělení liší vidlici od vidlice.</translation>
    </message>
    <message>
        <source>The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip.</source>
        <translation>Nejvíc listů, kolik jich nese větev poslední úrovně. Záporné hodnoty je dají do vějíře na špičku.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Hustota</translation>
    </message>
    <message>
        <source>Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays.</source>
        <translation>Pod 1 méně, ale větších listů, nad 1 více menších: plocha listů zůstává.</translation>
    </message>
    <message>
        <source>Turn to the light</source>
        <translation>Obracení ke světlu</translation>
    </message>
    <message>
        <source>How far the leaves turn outwards and up to the light.</source>
        <translation>Jak daleko se listy obracejí ven a vzhůru ke světlu.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Tvar</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Čepel</translation>
    </message>
    <message>
        <source>The kind of leaf: its outline where the form is &apos;outline&apos;. A card shows what its texture shows.</source>
        <translation>Druh listu: jeho obrys, je-li tvar „obrys“. Karta ukazuje svou texturu.</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Podoba</translation>
    </message>
    <message>
        <source>A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency.</source>
        <translation>Karta je obdélník s texturou listu. Obrys je vystřižen do tvaru a nepotřebuje průhlednost.</translation>
    </message>
    <message>
        <source>The length of a leaf.</source>
        <translation>Délka listu.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>The width of a leaf as a part of its length.</source>
        <translation>Šířka listu jako část jeho délky.</translation>
    </message>
    <message>
        <source>Stalk</source>
        <translation>Řapík</translation>
    </message>
    <message>
        <source>The length of the stalk between stem and blade, as a part of the leaf&apos;s length.</source>
        <translation>Délka stopky mezi větví a čepelí jako část délky listu.</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Přehnutí</translation>
    </message>
    <message>
        <source>How far each half of a leaf is folded up along its midrib.</source>
        <translation>Oč je každá polovina listu přehnutá vzhůru podél středního žebra.</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Zaoblení</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Stínování</translation>
    </message>
    <message>
        <source>Shades the leaves as if they were the surface of one round crown: softer light on dense crowns.</source>
        <translation>Stínuje listy, jako by byly povrchem jedné kulaté koruny: měkčí světlo na hustých korunách.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Síla</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Obálka</translation>
    </message>
    <message>
        <source>0 leaves the branches alone, 1 shortens them until they stay inside the envelope.</source>
        <translation>0 nechá větve být, 1 je zkracuje, dokud nezůstanou uvnitř obálky.</translation>
    </message>
    <message>
        <source>The radius of the envelope at its widest place, as a part of the tree&apos;s height.</source>
        <translation>Poloměr obálky v nejširším místě jako část výšky stromu.</translation>
    </message>
    <message>
        <source>Widest place</source>
        <translation>Nejširší místo</translation>
    </message>
    <message>
        <source>Where the envelope is widest, from 0 at its bottom to 1 at its top.</source>
        <translation>Kde je obálka nejširší, od 0 dole po 1 nahoře.</translation>
    </message>
    <message>
        <source>The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Obálka pod nejširším místem: pod 1 je vypouklá, 1 rovná, nad 1 prohnutá.</translation>
    </message>
    <message>
        <source>The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Obálka nad nejširším místem: pod 1 je vypouklá, 1 rovná, nad 1 prohnutá.</translation>
    </message>
    <message>
        <source>Bark repeats around</source>
        <translation>Opakování kůry kolem</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Kůra</translation>
    </message>
    <message>
        <source>How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam.</source>
        <translation>Kolikrát obrázek kůry obejde kmen; větve následují. Celá čísla nenechají šev.</translation>
    </message>
    <message>
        <source>Bark repeats along</source>
        <translation>Opakování kůry podél</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Druh</translation>
    </message>
    <message>
        <source>About</source>
        <translation>O stromu</translation>
    </message>
    <message>
        <source>The name of the kind of tree.</source>
        <translation>Název druhu stromu.</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Who made the file.</source>
        <translation>Kdo soubor vytvořil.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Popis</translation>
    </message>
    <message>
        <source>What the tree is like.</source>
        <translation>Jaký strom je.</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Oblíbená semínka</translation>
    </message>
    <message>
        <source>Seeds worth finding again, separated by blanks.</source>
        <translation>Semínka, která stojí za to znovu najít, oddělená mezerami.</translation>
    </message>
    <message>
        <source>Bark texture</source>
        <translation>Textura kůry</translation>
    </message>
    <message>
        <source>Leaf texture</source>
        <translation>Textura listu</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Listy</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: see Levels of stems.</source>
        <translation>Strom nemá větve této úrovně: viz Úrovně větvení.</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: a Number of branches is 0.</source>
        <translation>Strom nemá větve této úrovně: některý počet větví je 0.</translation>
    </message>
    <message>
        <source>This level would place the leaves, and the tree has none.</source>
        <translation>Tato úroveň by rozmístila listy, a strom žádné nemá.</translation>
    </message>
    <message>
        <source>Leaves grow on branches, and the tree is a bare trunk.</source>
        <translation>Listy rostou na větvích, a strom je holý kmen.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0.</source>
        <translation>Strom nemá listy: jejich počet je 0.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Kmen</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Větve</translation>
    </message>
    <message>
        <source>Pruning</source>
        <translation>Prořezávání</translation>
    </message>
    <message>
        <source>The picture on the stems; its path starts at the file&apos;s folder. A recipe as bark:furrowed seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Obrázek na dřevě; cesta začíná ve složce souboru. Předpis jako bark:furrowed seed=3 se nakreslí. Prázdné vezme vestavěný.</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>brázditá</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>šupinatá</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>hladká</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>bříza</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>vrba</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>třešeň</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>palma</translation>
    </message>
    <message>
        <source>Another bark of the same kind.</source>
        <translation>Jiná kůra téhož druhu.</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Hřebeny</translation>
    </message>
    <message>
        <source>How many ridges or plates stand side by side in the picture.</source>
        <translation>Kolik hřebenů nebo šupin stojí v obrázku vedle sebe.</translation>
    </message>
    <message>
        <source>Length of ridges</source>
        <translation>Délka hřebenů</translation>
    </message>
    <message>
        <source>How many times longer than wide they are.</source>
        <translation>Kolikrát jsou delší než širší.</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Praskliny</translation>
    </message>
    <message>
        <source>How wide the furrows between them are, as a part of a ridge.</source>
        <translation>Jak široké jsou brázdy mezi nimi, jako část hřebene.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Hloubka</translation>
    </message>
    <message>
        <source>How deep the relief is.</source>
        <translation>Jak hluboký je reliéf.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Zrno</translation>
    </message>
    <message>
        <source>How rough the surface is in detail.</source>
        <translation>Jak drsný je povrch zblízka.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Křivost</translation>
    </message>
    <message>
        <source>How crooked ridges and rings run.</source>
        <translation>Jak křivě běží hřebeny a prstence.</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Prstence</translation>
    </message>
    <message>
        <source>How many bands run around the stem in the picture.</source>
        <translation>Kolik pruhů v obrázku obíhá kmen.</translation>
    </message>
    <message>
        <source>Spots</source>
        <translation>Skvrny</translation>
    </message>
    <message>
        <source>How many pores or eyes there are.</source>
        <translation>Kolik je pórů nebo očí.</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Světlá barva</translation>
    </message>
    <message>
        <source>The colour of what stands out.</source>
        <translation>Barva toho, co vystupuje.</translation>
    </message>
    <message>
        <source>Dark colour</source>
        <translation>Tmavá barva</translation>
    </message>
    <message>
        <source>The colour of what lies deep.</source>
        <translation>Barva toho, co leží hluboko.</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Denní doba</translation>
    </message>
    <message>
        <source>Where the sun stands: low and red in the morning and in the evening.</source>
        <translation>Kde stojí slunce: ráno a večer nízko a rudé.</translation>
    </message>
    <message>
        <source>Sun direction</source>
        <translation>Směr slunce</translation>
    </message>
    <message>
        <source>Turns the sun&apos;s way about the tree.</source>
        <translation>Otáčí dráhu slunce kolem stromu.</translation>
    </message>
    <message>
        <source>lance</source>
        <translation>kopinatý</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>srdčitý</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>zpeřený</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>dlanitý</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>vějíř</translation>
    </message>
    <message>
        <source>Only cards have several planes: set Form to card.</source>
        <translation>Více rovin mají jen karty: nastavte Formu na kartu.</translation>
    </message>
    <message>
        <source>The tree has only one trunk.</source>
        <translation>Strom má jen jeden kmen.</translation>
    </message>
    <message>
        <source>The tree has no leaves, blossoms or fruits.</source>
        <translation>Strom nemá listy, květy ani plody.</translation>
    </message>
    <message>
        <source>The tree has no blossoms: their Number is 0.</source>
        <translation>Strom nemá květy: jejich Počet je 0.</translation>
    </message>
    <message>
        <source>The tree has no fruits: their Number is 0.</source>
        <translation>Strom nemá plody: jejich Počet je 0.</translation>
    </message>
    <message>
        <source>Month</source>
        <translation>Měsíc</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Roční období</translation>
    </message>
    <message>
        <source>The time of the year: 0 is New Year, 4.5 spring, 7 summer, 10 autumn. Leaves, their colour, blossoms and fruits follow.</source>
        <translation>Doba roku: 0 je Nový rok, 4,5 jaro, 7 léto, 10 podzim. Řídí se jí listy, jejich barva, květy a plody.</translation>
    </message>
    <message>
        <source>Evergreen</source>
        <translation>Stálezelený</translation>
    </message>
    <message>
        <source>On: the leaves stay, and stay green, through the winter.</source>
        <translation>Zapnuto: listy zůstávají přes zimu, a zelené.</translation>
    </message>
    <message>
        <source>Trunks</source>
        <translation>Kmeny</translation>
    </message>
    <message>
        <source>Several trunks</source>
        <translation>Více kmenů</translation>
    </message>
    <message>
        <source>How many trunks rise from one base: shrubs, clumps of bamboo.</source>
        <translation>Kolik kmenů roste z jednoho základu: keře, trsy bambusu.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Rozestup</translation>
    </message>
    <message>
        <source>How far from the middle the outermost trunk stands.</source>
        <translation>Jak daleko od středu stojí krajní kmen.</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Náklon</translation>
    </message>
    <message>
        <source>How far the outermost trunk leans outwards; the others less.</source>
        <translation>Jak moc se krajní kmen kloní ven; ostatní méně.</translation>
    </message>
    <message>
        <source>At one place</source>
        <translation>Na jednom místě</translation>
    </message>
    <message>
        <source>How many branches leave their parent at the same height, all around it: 2 are opposite, more a whorl.</source>
        <translation>Kolik větví vyrůstá ve stejné výšce kolem dokola: 2 jsou vstřícné, více tvoří přeslen.</translation>
    </message>
    <message>
        <source>How many leaves leave a stem at the same place: 1 are alternate, 2 opposite, more a whorl.</source>
        <translation>Kolik listů vyrůstá na stejném místě: 1 střídavé, 2 vstřícné, více přeslen.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Roviny</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one leaf: 2 or 3 for tufts and twigs of needles.</source>
        <translation>Kolik karet pootočených kolem délky tvoří jeden list: 2 nebo 3 pro svazky a větvičky jehlic.</translation>
    </message>
    <message>
        <source>Blossoms</source>
        <translation>Květy</translation>
    </message>
    <message>
        <source>The most blossoms that a stem of the last level bears. They stand where leaves could.</source>
        <translation>Nejvyšší počet květů na stonku poslední úrovně. Stojí tam, kde by mohly být listy.</translation>
    </message>
    <message>
        <source>The length and width of a blossom, or of the cluster that its picture shows.</source>
        <translation>Délka a šířka květu, nebo květenství na jeho obrázku.</translation>
    </message>
    <message>
        <source>When the tree is in full blossom; it begins and ends most of a month before and after.</source>
        <translation>Kdy je strom v plném květu; začíná a končí skoro měsíc předtím a potom.</translation>
    </message>
    <message>
        <source>Fruits</source>
        <translation>Plody</translation>
    </message>
    <message>
        <source>The most fruits that a stem of the last level bears.</source>
        <translation>Nejvyšší počet plodů na stonku poslední úrovně.</translation>
    </message>
    <message>
        <source>The length of a ripe fruit.</source>
        <translation>Délka zralého plodu.</translation>
    </message>
    <message>
        <source>The width of a fruit as a part of its length: small for cones and pods.</source>
        <translation>Šířka plodu jako díl jeho délky: malá pro šišky a lusky.</translation>
    </message>
    <message>
        <source>The length of the stalk that a fruit hangs on, as a part of its own length.</source>
        <translation>Délka stopky, na které plod visí, jako díl jeho délky.</translation>
    </message>
    <message>
        <source>When the fruits are ripe. They grow in the two months before and fall in the month after.</source>
        <translation>Kdy jsou plody zralé. Rostou dva měsíce předtím a padají měsíc potom.</translation>
    </message>
    <message>
        <source>The picture on the leaves, transparent outside the blade. A recipe as leaf:oak seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Obrázek na listech, mimo čepel průhledný. Recept jako leaf:oak seed=3 se nakreslí. Prázdné bere vestavěný.</translation>
    </message>
    <message>
        <source>Blossom texture</source>
        <translation>Textura květů</translation>
    </message>
    <message>
        <source>Blossoms and fruits</source>
        <translation>Květy a plody</translation>
    </message>
    <message>
        <source>The picture on the blossoms. Empty draws leaf:blossom.</source>
        <translation>Obrázek na květech. Prázdné kreslí leaf:blossom.</translation>
    </message>
    <message>
        <source>Fruit texture</source>
        <translation>Textura plodů</translation>
    </message>
    <message>
        <source>The skin of the fruits. Empty draws a red one.</source>
        <translation>Slupka plodů. Prázdné kreslí červenou.</translation>
    </message>
    <message>
        <source>Blossoms and fruits grow on branches, and the tree is a bare trunk.</source>
        <translation>Květy a plody rostou na větvích a strom je holý kmen.</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Květ</translation>
    </message>
    <message>
        <source>beech</source>
        <translation>buk</translation>
    </message>
    <message>
        <source>oak</source>
        <translation>dub</translation>
    </message>
    <message>
        <source>aspen</source>
        <translation>osika</translation>
    </message>
    <message>
        <source>lime</source>
        <translation>lípa</translation>
    </message>
    <message>
        <source>apple</source>
        <translation>jabloň</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>oliva</translation>
    </message>
    <message>
        <source>bamboo</source>
        <translation>bambus</translation>
    </message>
    <message>
        <source>maple</source>
        <translation>javor</translation>
    </message>
    <message>
        <source>japanese-maple</source>
        <translation>javor dlanitolistý</translation>
    </message>
    <message>
        <source>ash</source>
        <translation>jasan</translation>
    </message>
    <message>
        <source>acacia</source>
        <translation>akácie</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>palmový list</translation>
    </message>
    <message>
        <source>chestnut</source>
        <translation>jírovec</translation>
    </message>
    <message>
        <source>pine</source>
        <translation>borovice</translation>
    </message>
    <message>
        <source>spruce</source>
        <translation>smrk</translation>
    </message>
    <message>
        <source>larch</source>
        <translation>modřín</translation>
    </message>
    <message>
        <source>cedar</source>
        <translation>cedr</translation>
    </message>
    <message>
        <source>cypress</source>
        <translation>cypřiš</translation>
    </message>
    <message>
        <source>flower</source>
        <translation>květ</translation>
    </message>
    <message>
        <source>blossom</source>
        <translation>květenství</translation>
    </message>
    <message>
        <source>Another leaf of the same kind.</source>
        <translation>Jiný list téhož druhu.</translation>
    </message>
    <message>
        <source>The width of the picture as a part of its length. Give Width of the tree&apos;s leaves the same value.</source>
        <translation>Šířka obrázku jako díl délky. Šířce listů stromu dejte stejnou hodnotu.</translation>
    </message>
    <message>
        <source>The part of the length that is stalk.</source>
        <translation>Díl délky, který je řapík.</translation>
    </message>
    <message>
        <source>Where a blade is widest, from 0 at its foot to 1 at its tip.</source>
        <translation>Kde je čepel nejširší, od 0 u paty po 1 na špičce.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Pata</translation>
    </message>
    <message>
        <source>Below 1 the blade begins round, above 1 like a wedge.</source>
        <translation>Pod 1 začíná čepel zaobleně, nad 1 klínovitě.</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Špička</translation>
    </message>
    <message>
        <source>Below 1 the blade ends round, above 1 in a drawn-out point.</source>
        <translation>Pod 1 končí čepel zaobleně, nad 1 protáhlou špičkou.</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Srdce</translation>
    </message>
    <message>
        <source>How far the blade reaches back beside its stalk.</source>
        <translation>Jak daleko sahá čepel zpět podél řapíku.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zuby</translation>
    </message>
    <message>
        <source>How many teeth each half of a blade has.</source>
        <translation>Kolik zubů má každá půle čepele.</translation>
    </message>
    <message>
        <source>Depth of teeth</source>
        <translation>Hloubka zubů</translation>
    </message>
    <message>
        <source>How deep they are cut, as a part of the half&apos;s width.</source>
        <translation>Jak hluboko jsou vykrojeny, jako díl šířky půle.</translation>
    </message>
    <message>
        <source>Depth of lobes</source>
        <translation>Hloubka laloků</translation>
    </message>
    <message>
        <source>How deep they are cut. Of leaflets and needles: how wide they are.</source>
        <translation>Jak hluboko jsou vykrojeny. U lístků a jehlic: jak jsou široké.</translation>
    </message>
    <message>
        <source>Slant</source>
        <translation>Sklon</translation>
    </message>
    <message>
        <source>How far teeth and lobes lean towards the tip.</source>
        <translation>Jak moc se zuby a laloky kloní ke špičce.</translation>
    </message>
    <message>
        <source>Leaflets</source>
        <translation>Lístky</translation>
    </message>
    <message>
        <source>Pairs of leaflets, leaflets of a hand, needles or petals.</source>
        <translation>Páry lístků, lístky dlaně, jehlice nebo okvětní lístky.</translation>
    </message>
    <message>
        <source>How far lobes, leaflets or needles stand off, in degrees.</source>
        <translation>Jak daleko odstávají laloky, lístky nebo jehlice, ve stupních.</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Žilky</translation>
    </message>
    <message>
        <source>How many veins leave the midrib on each side.</source>
        <translation>Kolik žilek vychází z hlavní žilky na každé straně.</translation>
    </message>
    <message>
        <source>Blemishes</source>
        <translation>Vady</translation>
    </message>
    <message>
        <source>How many spots and worn places there are.</source>
        <translation>Kolik je skvrn a opotřebených míst.</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Lesk</translation>
    </message>
    <message>
        <source>How much the upper side shines.</source>
        <translation>Jak moc se leskne horní strana.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Barva</translation>
    </message>
    <message>
        <source>The colour in summer.</source>
        <translation>Barva v létě.</translation>
    </message>
    <message>
        <source>Veins&apos; colour</source>
        <translation>Barva žilek</translation>
    </message>
    <message>
        <source>The colour of veins and stalks.</source>
        <translation>Barva žilek a řapíků.</translation>
    </message>
    <message>
        <source>Autumn colour</source>
        <translation>Podzimní barva</translation>
    </message>
    <message>
        <source>The colour when the green has gone.</source>
        <translation>Barva, když zeleň zmizí.</translation>
    </message>
    <message>
        <source>0.5 is the middle of January, 7 the height of summer, 10.5 late autumn.</source>
        <translation>0,5 je polovina ledna, 7 vrchol léta, 10,5 pozdní podzim.</translation>
    </message>
    <message>
        <source>candle</source>
        <translation>svíce</translation>
    </message>
    <message>
        <source>The trunk has no roots.</source>
        <translation>Kmen nemá kořeny.</translation>
    </message>
    <message>
        <source>Roots</source>
        <translation>Kořeny</translation>
    </message>
    <message>
        <source>The number of ridges that run from the trunk into the ground. High ones are buttresses.</source>
        <translation>Počet hřebenů, které vybíhají z kmene do země. Vysoké jsou opěrné kořeny.</translation>
    </message>
    <message>
        <source>Reach of roots</source>
        <translation>Dosah kořenů</translation>
    </message>
    <message>
        <source>How far the roots reach out of the trunk on the ground, in radii of the trunk.</source>
        <translation>Jak daleko kořeny na zemi vybíhají z kmene, v poloměrech kmene.</translation>
    </message>
    <message>
        <source>Height of roots</source>
        <translation>Výška kořenů</translation>
    </message>
    <message>
        <source>Where the roots leave the trunk, as a part of its length.</source>
        <translation>Kde kořeny opouštějí kmen, jako díl jeho délky.</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Vzpřímení</translation>
    </message>
    <message>
        <source>1 sets blossoms upright like candles, -1 lets them hang like catkins, 0 lets them stand like leaves.</source>
        <translation>1 postaví květy jako svíce, -1 je nechá viset jako jehnědy, 0 stát jako listy.</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one blossom: 2 or 3 for candles and catkins.</source>
        <translation>Kolik karet pootočených kolem délky tvoří jeden květ: 2 nebo 3 pro svíce a jehnědy.</translation>
    </message>
    <message>
        <source>Min radius</source>
        <translation>Min. poloměr</translation>
    </message>
    <message>
        <source>Weber and Penn</source>
        <translation>Weber a Penn</translation>
    </message>
    <message>
        <source>Botanical values by level: trunk, branches, twigs. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</source>
        <translation>Botanické hodnoty po úrovních: kmen, větve, větvičky. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</translation>
    </message>
    <message>
        <source>Memory for a tree</source>
        <translation>Paměť pro strom</translation>
    </message>
    <message>
        <source>The most that a tree may take while it is made; 0 is half of what is free.</source>
        <translation>Kolik nejvýše smí strom zabrat, když vzniká; 0 je polovina volné paměti.</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>Grammar</source>
        <translation>Gramatika</translation>
    </message>
    <message>
        <source>Nothing bends: the strength of the tropism is 0.</source>
        <translation>Nic se neohýbá: síla tropismu je 0.</translation>
    </message>
    <message>
        <source>Every turn of the grammar has a number.</source>
        <translation>Každé otočení v gramatice má své číslo.</translation>
    </message>
    <message>
        <source>It places the leaves of stems: their Number is 0. Leaves that the grammar writes stand where it says.</source>
        <translation>Umisťuje listy na větvích: jejich Počet je 0. Listy, které píše gramatika, stojí tam, kde určí.</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Pravidla</translation>
    </message>
    <message>
        <source>The rules that the tree grows by: values, an axiom, and productions that rewrite every module of the word at once.</source>
        <translation>Pravidla, podle nichž strom roste: hodnoty, axiom a produkce, které přepisují všechny moduly slova najednou.</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Derivace</translation>
    </message>
    <message>
        <source>How often the word is rewritten.</source>
        <translation>Kolikrát se slovo přepíše.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Jednotka délky</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Želva</translation>
    </message>
    <message>
        <source>How long F(1) is.</source>
        <translation>Jak dlouhé je F(1).</translation>
    </message>
    <message>
        <source>Unit of width</source>
        <translation>Jednotka šířky</translation>
    </message>
    <message>
        <source>How thick wood of the width !(1) is: a diameter.</source>
        <translation>Jak tlusté je dřevo šířky !(1): průměr.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Úhel</translation>
    </message>
    <message>
        <source>How far + - &amp; ^ \ / turn where they have no number.</source>
        <translation>Jak daleko otáčejí + - &amp; ^ \ / bez čísla.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropismus</translation>
    </message>
    <message>
        <source>How far every F bends towards the tropism&apos;s direction when it stands square to it, in radians.</source>
        <translation>Jak daleko se každé F ohne ke směru tropismu, stojí-li k němu kolmo, v radiánech.</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Směr X</translation>
    </message>
    <message>
        <source>Where stems bend to: gravity points down, light up, wind aside.</source>
        <translation>Kam se větve ohýbají: tíže míří dolů, světlo nahoru, vítr stranou.</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Směr Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Směr Z</translation>
    </message>
    <message>
        <source>Where stems bend to: -1 is down.</source>
        <translation>Kam se větve ohýbají: -1 je dolů.</translation>
    </message>
    <message>
        <source>How many leaves a stem without branches bears, besides those that the grammar writes as ~L.</source>
        <translation>Kolik listů nese větev bez odnoží, kromě těch, které gramatika píše jako ~L.</translation>
    </message>
    <message>
        <source>The angle between these leaves and their stem.</source>
        <translation>Úhel mezi těmito listy a jejich větví.</translation>
    </message>
    <message>
        <source>The turn about the stem from one of these leaves to the next.</source>
        <translation>Otočení kolem větve od jednoho z těchto listů k dalšímu.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0, and the grammar writes no ~L.</source>
        <translation>Strom nemá listy: jejich Počet je 0 a gramatika nepíše žádné ~L.</translation>
    </message>
    <message>
        <source>L-system</source>
        <translation>L-systém</translation>
    </message>
    <message>
        <source>A grammar rewrites a word, and a turtle draws it. The Algorithmic Beauty of Plants, chapters 1 and 2.</source>
        <translation>Gramatika přepisuje slovo a želva je kreslí. The Algorithmic Beauty of Plants, kapitoly 1 a 2.</translation>
    </message>
    <message>
        <source>L-systems (*.l *.lsys)</source>
        <translation>L-systémy (*.l *.lsys)</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Prameny</translation>
    </message>
    <message>
        <source>Turns aside (Gravelius order)</source>
        <translation>Odbočení (řád podle Gravelia)</translation>
    </message>
    <message>
        <source>Splits below (Weibull order)</source>
        <translation>Dělení pod ní (řád podle Weibulla)</translation>
    </message>
    <message>
        <source>height, m</source>
        <translation>výška, m</translation>
    </message>
    <message>
        <source>from the root, m</source>
        <translation>od kořene, m</translation>
    </message>
    <message>
        <source>thickness, cm</source>
        <translation>tloušťka, cm</translation>
    </message>
    <message>
        <source>turns aside</source>
        <translation>odbočení</translation>
    </message>
    <message>
        <source>splits below</source>
        <translation>dělení pod ní</translation>
    </message>
    <message>
        <source>order</source>
        <translation>řád</translation>
    </message>
    <message>
        <source>height</source>
        <translation>výška</translation>
    </message>
    <message>
        <source>rootLength</source>
        <translation>délka od kořene</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>tloušťka</translation>
    </message>
    <message>
        <source>What the curve runs over: the number of turns aside from the trunk (order), or the height in metres, the length from the root in metres, the thickness in centimetres of the branch that splits, at its base.</source>
        <translation>Přes co křivka běží: počet odbočení od kmene (řád), nebo výška v metrech, délka od kořene v metrech či tloušťka v centimetrech u paty větve, která se dělí.</translation>
    </message>
    <message>
        <source>It places the leaves of twigs: their Number is 0.</source>
        <translation>Rozmisťuje listy větviček: jejich počet je 0.</translation>
    </message>
    <message>
        <source>How many strands the trunk has, S: each of them ends in a twig of its own, so a tree has as many twigs and 2S - 1 branches.</source>
        <translation>Kolik pramenů má kmen, S: každý končí ve vlastní větvičce, strom má tedy stejně tolik větviček a 2S - 1 větví.</translation>
    </message>
    <message>
        <source>Height of the trunk</source>
        <translation>Výška kmene</translation>
    </message>
    <message>
        <source>How long the trunk is below its first split.</source>
        <translation>Jak dlouhý je kmen pod prvním dělením.</translation>
    </message>
    <message>
        <source>Inherited length</source>
        <translation>Zděděná délka</translation>
    </message>
    <message>
        <source>The length that the first branches inherit, L: every split hands a part of it on.</source>
        <translation>Délka, kterou dědí první větve, L: každé dělení předá její část dál.</translation>
    </message>
    <message>
        <source>Thickness of a strand</source>
        <translation>Tloušťka pramene</translation>
    </message>
    <message>
        <source>How thick a branch of one strand is. One of S strands has the diameter d = this times the root of S, so that the wood above a split has the area of that below.</source>
        <translation>Jak silná je větev s jedním pramenem. Větev s S prameny má průměr d = tato hodnota krát odmocnina z S, takže dřevo nad dělením má stejný průřez jako pod ním.</translation>
    </message>
    <message>
        <source>Strands of the leader</source>
        <translation>Prameny vedoucí větve</translation>
    </message>
    <message>
        <source>Shares</source>
        <translation>Podíly</translation>
    </message>
    <message>
        <source>The part of the strands that goes on in the leader at a split, k_s: it gets S1 = 1 + (k_s (S - 2) rounded up), the side branch the rest. 0.5 splits evenly, 1 makes a single axis with twigs.</source>
        <translation>Část pramenů, která při dělení pokračuje ve vedoucí větvi, k_s: dostane S1 = 1 + (k_s (S - 2) zaokrouhleno nahoru), boční větev zbytek. 0,5 dělí rovným dílem, 1 dá jedinou osu s větvičkami.</translation>
    </message>
    <message>
        <source>Turn of the leader</source>
        <translation>Natočení vedoucí větve</translation>
    </message>
    <message>
        <source>Gravicentralism, k_c: the leader turns aside by this times the split angle times the root of S2 / S, the side branch by the rest. 0 goes straight on, as many trunks do.</source>
        <translation>Gravicentralismus, k_c: vedoucí větev uhne o tuto hodnotu krát úhel dělení krát odmocnina z S2 / S, boční větev o zbytek. 0 pokračuje rovně jako mnohé kmeny.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Úhly</translation>
    </message>
    <message>
        <source>The angle between leader and side branch at a split, α.</source>
        <translation>Úhel mezi vedoucí a boční větví při dělení, α.</translation>
    </message>
    <message>
        <source>Turn of the plane</source>
        <translation>Natočení roviny</translation>
    </message>
    <message>
        <source>How far the plane of a split is turned about the branch against the one before: 90 and 137.5 wind about it, 0 and 180 lie flat.</source>
        <translation>O kolik je rovina dělení natočena kolem větve proti předchozí: 90 a 137,5 se kolem ní vinou, 0 a 180 leží v ploše.</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Převis</translation>
    </message>
    <message>
        <source>Gravimorphism: how far every branch turns towards the ground after a split, until it hangs.</source>
        <translation>Gravimorfismus: o kolik se každá větev po dělení stočí k zemi, dokud nevisí.</translation>
    </message>
    <message>
        <source>Min length ratio</source>
        <translation>Nejmenší poměr délek</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Délky</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at least this part, k_m.</source>
        <translation>Větev dědí délku té pod ní krát odmocnina ze svého podílu pramenů, nejméně však tuto část, k_m.</translation>
    </message>
    <message>
        <source>Max length ratio</source>
        <translation>Největší poměr délek</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at most this part, k_M.</source>
        <translation>Větev dědí délku té pod ní krát odmocnina ze svého podílu pramenů, nejvýše však tuto část, k_M.</translation>
    </message>
    <message>
        <source>Drawn length</source>
        <translation>Kreslená délka</translation>
    </message>
    <message>
        <source>How much of the inherited length the branches above a split are drawn with, k_l; what they hand on stays the same.</source>
        <translation>Jaká část zděděné délky se u větví nad dělením kreslí, k_l; co předávají dál, zůstává.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Obměna</translation>
    </message>
    <message>
        <source>How far angles stray from the curves, by the seed: 0 gives every tree the same form.</source>
        <translation>Jak daleko se úhly podle semínka odchylují od křivek: 0 dá každému stromu stejný tvar.</translation>
    </message>
    <message>
        <source>Factors by depth</source>
        <translation>Činitele podle hloubky</translation>
    </message>
    <message>
        <source>A factor of this value over the depth: how many splits lie below.</source>
        <translation>Činitel této hodnoty podle hloubky: kolik dělení leží pod větví.</translation>
    </message>
    <message>
        <source>What curves run over</source>
        <translation>Přes co křivky běží</translation>
    </message>
    <message>
        <source>How many leaves a twig of one strand bears.</source>
        <translation>Kolik listů nese větvička s jedním pramenem.</translation>
    </message>
    <message>
        <source>The angle between the leaves and their twig.</source>
        <translation>Úhel mezi listy a jejich větvičkou.</translation>
    </message>
    <message>
        <source>The turn about the twig from one leaf to the next.</source>
        <translation>Otočení kolem větvičky od jednoho listu k dalšímu.</translation>
    </message>
    <message>
        <source>Strand model</source>
        <translation>Model pramenů</translation>
    </message>
    <message>
        <source>A trunk of strands that split again and again until each is a twig: drawn curves say how. Holton 1994.</source>
        <translation>Kmen z pramenů, které se znovu a znovu dělí, až je každý větvičkou: jak, to říkají nakreslené křivky. Holton 1994.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádný</translation>
    </message>
    <message>
        <source>Attributes for a shader</source>
        <translation>Atributy pro shader</translation>
    </message>
    <message>
        <source>CryEngine vertex colours</source>
        <translation>Barvy vrcholů CryEngine</translation>
    </message>
    <message>
        <source>Unity Tree Creator colours</source>
        <translation>Barvy Unity Tree Creator</translation>
    </message>
    <message>
        <source>Bones with clips</source>
        <translation>Kosti s klipy</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Kosti</translation>
    </message>
    <message>
        <source>How many of the thickest stems get a bone of their own; the others follow theirs. Only with bones.</source>
        <translation>Kolik nejtlustších kmenů a větví dostane vlastní kost; ostatní je následují. Jen s kostmi.</translation>
    </message>
    <message>
        <source>%1 cannot hold what moves in the wind; choose glTF</source>
        <translation>%1 neumí uložit pohyb ve větru; zvolte glTF</translation>
    </message>
    <message>
        <source>1 is a strong gale, 22 m/s; beyond it is a storm.</source>
        <translation>1 je silná vichřice, 22 m/s; nad ní je bouře.</translation>
    </message>
    <message>
        <source>Where it blows to; the arrow in the picture can be dragged too.</source>
        <translation>Kam vane; lze také táhnout šipku v obrázku.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Poryvy</translation>
    </message>
    <message>
        <source>How much of the strength comes and goes.</source>
        <translation>Jak velká část síly přichází a odchází.</translation>
    </message>
    <message>
        <source>Flexibility</source>
        <translation>Ohebnost</translation>
    </message>
    <message>
        <source>How far the wood bends in the wind: 0 is stiff, 2 bends twice as far. The tree in still air stays as it is.</source>
        <translation>Jak moc se dřevo ohýbá ve větru: 0 je tuhé, 2 se ohýbá dvakrát víc. Strom v klidu zůstává, jaký je.</translation>
    </message>
    <message>
        <source>Unreal Pivot Painter 2 pictures</source>
        <translation>Obrázky pro Pivot Painter 2 (Unreal)</translation>
    </message>
    <message>
        <source>What lets the tree sway in another program: vertex attributes and a table for a shader, vertex colours as an engine reads them (COLOR_0 then tints the tree where they are not read), pictures of pivots for Unreal, or bones with clips of wind and growth.</source>
        <translation>Co strom rozhoupe v jiném programu: atributy vrcholů a tabulka pro shader, barvy vrcholů, jak je čte engine (COLOR_0 strom obarví tam, kde se nečtou), obrázky otočných bodů pro Unreal, nebo kosti s klipy větru a růstu.</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>větev</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>vodorovně</translation>
    </message>
    <message>
        <source>Nothing attracts the branches: Attraction up is 0.</source>
        <translation>Větve nic nevzpřimuje: Vzpřimování je 0.</translation>
    </message>
    <message>
        <source>Attraction axis</source>
        <translation>Osa vzpřimování</translation>
    </message>
    <message>
        <source>What attraction turns a branch about. &apos;stem&apos;, as the paper prints it: its own axis, so that one that lies on its side stays. &apos;horizontal&apos;: all hang, or reach up, alike.</source>
        <translation>Kolem čeho vzpřimování otáčí větev. „větev“, jak je vytištěno v článku: kolem vlastní osy, takže ta, která leží na boku, zůstane. „vodorovně“: všechny visí nebo se zvedají stejně.</translation>
    </message>
    <message>
        <source>Sun strength</source>
        <translation>Síla slunce</translation>
    </message>
    <message>
        <source>0 is an overcast day without shadows, 1 a clear one.</source>
        <translation>0 je zatažený den beze stínů, 1 jasný.</translation>
    </message>
    <message>
        <source>The colour of its light: low is warm and red, high is cold and blue.</source>
        <translation>Barva jeho světla: nízká je teplá a červená, vysoká studená a modrá.</translation>
    </message>
    <message>
        <source>Sky strength</source>
        <translation>Síla oblohy</translation>
    </message>
    <message>
        <source>How bright the sky is: what lights the shadows.</source>
        <translation>Jak jasná je obloha: co osvětluje stíny.</translation>
    </message>
    <message>
        <source>The colour of the sky: low is warm, high is blue.</source>
        <translation>Barva oblohy: nízká je teplá, vysoká modrá.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Expozice</translation>
    </message>
    <message>
        <source>Makes the whole picture brighter or darker: each stop doubles the light.</source>
        <translation>Celý obraz zesvětlí nebo ztmaví: každý stupeň světlo zdvojnásobí.</translation>
    </message>
    <message>
        <source>Colour variation</source>
        <translation>Rozdíly v barvě</translation>
    </message>
    <message>
        <source>How much leaves differ in hue and lightness, in the window and in its pictures. 0: all are alike.</source>
        <translation>Jak se listy liší odstínem a světlostí, v okně a na jeho obrázcích. 0: všechny jsou stejné.</translation>
    </message>
    <message>
        <source>Remeshed in voxels</source>
        <translation>Nová síť z voxelů</translation>
    </message>
    <message>
        <source>One solid</source>
        <translation>Jedno těleso</translation>
    </message>
    <message>
        <source>For printing: all wood as one closed surface, without leaves. Of up to 5,000 stems.</source>
        <translation>Pro tisk: všechno dřevo jako jedna uzavřená plocha, bez listů. Nejvýše 5000 výhonů.</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Velikost voxelu</translation>
    </message>
    <message>
        <source>The edge of the cubes that a solid is made of, in metres of the tree. Thinner wood becomes as thick.</source>
        <translation>Hrana krychlí, z nichž je těleso, v metrech stromu. Tenčí dřevo se na ni zesílí.</translation>
    </message>
    <message>
        <source>one solid has no levels of detail and does not move in the wind</source>
        <translation>jedno těleso nemá úrovně detailů a nehýbe se ve větru</translation>
    </message>
    <message>
        <source>How often the bark picture would repeat from the trunk&apos;s base to its tip if it stayed as thick. Thinner wood shows it smaller, undistorted.</source>
        <translation>Kolikrát by se obrázek kůry opakoval od paty kmene ke špičce, kdyby zůstal stejně tlustý. Tenčí dřevo jej ukazuje menší, nezkreslený.</translation>
    </message>
    <message>
        <source>The picture on branches, which have a material of their own then. The trunk shows it where it is as thin as they are. Empty: as the trunk.</source>
        <translation>Obrázek na větvích, které pak mají vlastní materiál. Kmen jej ukazuje tam, kde je stejně tenký jako ony. Prázdné: jako kmen.</translation>
    </message>
    <message>
        <source>curved</source>
        <translation>prohnutý</translation>
    </message>
    <message>
        <source>cupped</source>
        <translation>miskovitý</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>zvlněný</translation>
    </message>
    <message>
        <source>rolled</source>
        <translation>svinutý</translation>
    </message>
    <message>
        <source>The leaf has a mesh of its own.</source>
        <translation>List má vlastní síť.</translation>
    </message>
    <message>
        <source>The mesh keeps its proportions.</source>
        <translation>Síť si zachová své poměry.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Síť</translation>
    </message>
    <message>
        <source>A mesh in place of a card: mesh:curved and the like, or a file (.obj, .glb) whose foot is the origin; its path starts at the file&apos;s folder. The leaf texture lies on it by its texture coordinates.</source>
        <translation>Síť místo karty: mesh:curved a podobné, nebo soubor (.obj, .glb), jehož pata je počátek; cesta začíná ve složce souboru. Textura listu na ní leží podle jejích texturovacích souřadnic.</translation>
    </message>
    <message>
        <source>Leaf texture 2</source>
        <translation>Textura listu 2</translation>
    </message>
    <message>
        <source>Leaf texture 3</source>
        <translation>Textura listu 3</translation>
    </message>
    <message>
        <source>Leaf texture 4</source>
        <translation>Textura listu 4</translation>
    </message>
    <message>
        <source>Mesh 2</source>
        <translation>Síť 2</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Druhy</translation>
    </message>
    <message>
        <source>Mesh 3</source>
        <translation>Síť 3</translation>
    </message>
    <message>
        <source>Mesh 4</source>
        <translation>Síť 4</translation>
    </message>
    <message>
        <source>Share 2</source>
        <translation>Podíl 2</translation>
    </message>
    <message>
        <source>Share 3</source>
        <translation>Podíl 3</translation>
    </message>
    <message>
        <source>Share 4</source>
        <translation>Podíl 4</translation>
    </message>
    <message>
        <source>The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind.</source>
        <translation>Obrázek na listech tohoto druhu, které pak mají vlastní materiál. Prázdné: jako první druh.</translation>
    </message>
    <message>
        <source>The mesh of leaves of this kind. Empty: as the first kind.</source>
        <translation>Síť listů tohoto druhu. Prázdné: jako první druh.</translation>
    </message>
    <message>
        <source>The part of the leaves that is of this kind, with a texture or a mesh of its own.</source>
        <translation>Část listů, která je tohoto druhu, s vlastní texturou nebo sítí.</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>vestavěná</translation>
    </message>
    <message>
        <source>Bark of branches 1</source>
        <translation>Kůra větví 1</translation>
    </message>
    <message>
        <source>as the trunk</source>
        <translation>jako kmen</translation>
    </message>
    <message>
        <source>Bark of branches 2</source>
        <translation>Kůra větví 2</translation>
    </message>
    <message>
        <source>The picture on branches of branches, which have a material of their own then. Thin branches show it too. Empty: as branches 1.</source>
        <translation>Obrázek na větvích větví, které pak mají vlastní materiál. Ukazují jej i tenké větve. Prázdné: jako větve 1.</translation>
    </message>
    <message>
        <source>as branches 1</source>
        <translation>jako větve 1</translation>
    </message>
    <message>
        <source>Bark of branches 3</source>
        <translation>Kůra větví 3</translation>
    </message>
    <message>
        <source>The picture on branches 3 and deeper ones, which have a material of their own then. Thin branches 2 show it too. Empty: as branches 2.</source>
        <translation>Obrázek na větvích 3 a hlubších, které pak mají vlastní materiál. Ukazují jej i tenké větve 2. Prázdné: jako větve 2.</translation>
    </message>
    <message>
        <source>as branches 2</source>
        <translation>jako větve 2</translation>
    </message>
    <message>
        <source>as the first kind</source>
        <translation>jako první druh</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Posunutí povrchu</translation>
    </message>
    <message>
        <source>The relief of the bark as triangles, in cells of so many metres: 0.02 for a trunk seen from near; 0: none. Only level of detail 0 gets it.</source>
        <translation>Reliéf kůry jako trojúhelníky, v buňkách o tolika metrech: 0,02 pro kmen zblízka; 0: žádný. Dostane jej jen úroveň detailu 0.</translation>
    </message>
    <message>
        <source>Strength of displacement</source>
        <translation>Síla posunutí</translation>
    </message>
    <message>
        <source>How deep displaced bark is: 1 is what the picture of its normals shows. Seen from near it may be more.</source>
        <translation>Jak hluboká je posunutá kůra: 1 je to, co ukazuje obrázek jejích normál. Zblízka jí může být víc.</translation>
    </message>
    <message>
        <source>only the full model&apos;s level of detail 0 has displaced bark</source>
        <translation>posunutou kůru má jen úroveň detailu 0 úplného modelu</translation>
    </message>
    <message>
        <source>Sun and shade</source>
        <translation>Slunce a stín</translation>
    </message>
    <message>
        <source>How much leaves that grow in the shade of the crown differ from those in the sun: at 1 they are 1.6 times as long and wide, and darker in the window and its pictures.</source>
        <translation>Jak se listy, které rostou ve stínu koruny, liší od těch na slunci: při 1 jsou 1,6krát delší a širší a v okně a na jeho obrázcích tmavší.</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>Vyklenutí</translation>
    </message>
    <message>
        <source>How far the middle of a cluster of blossoms stands out: 0 is a flat card, at 1 its edge lies half its width lower.</source>
        <translation>Jak daleko vystupuje střed květenství: 0 je plochá karta, při 1 leží její okraj o půl šířky níž.</translation>
    </message>
    <message>
        <source>How many lobes a half, or a hand-shaped leaf, has. Of blossoms: how many flowers. Of spruce twigs: how many pairs of side twigs.</source>
        <translation>Kolik laloků má půle nebo dlanitý list. U květenství: kolik květů. U smrkových větviček: kolik párů postranních větviček.</translation>
    </message>
    <message>
        <source>random</source>
        <translation>náhoda</translation>
    </message>
    <message>
        <source>autumn winter spring date</source>
        <translation>podzim zima jaro datum</translation>
    </message>
    <message>
        <source>stiff sway</source>
        <translation>tuhost kývání</translation>
    </message>
    <message>
        <source>root collar buttress base</source>
        <translation>kořenový krček opěrné kořeny pata</translation>
    </message>
    <message>
        <source>size</source>
        <translation>velikost</translation>
    </message>
    <message>
        <source>hue tint random</source>
        <translation>odstín barva náhoda</translation>
    </message>
    <message>
        <source>gravity droop weeping</source>
        <translation>gravitace převis smuteční</translation>
    </message>
    <message>
        <source>crown base height clear</source>
        <translation>výška koruny čistý kmen</translation>
    </message>
    <message>
        <source>order recursion generations</source>
        <translation>řád rekurze generace</translation>
    </message>
    <message>
        <source>girth radius diameter width</source>
        <translation>obvod poloměr průměr šířka</translation>
    </message>
    <message>
        <source>gravity droop weeping hang</source>
        <translation>gravitace převis smuteční visí</translation>
    </message>
    <message>
        <source>shrub clump multi-stem</source>
        <translation>keř trs vícekmen</translation>
    </message>
    <message>
        <source>count density</source>
        <translation>počet hustota</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>sklon</translation>
    </message>
    <message>
        <source>twist spiral phyllotaxis</source>
        <translation>zkrut spirála fylotaxe</translation>
    </message>
    <message>
        <source>bend arch</source>
        <translation>ohyb oblouk</translation>
    </message>
    <message>
        <source>fork clone</source>
        <translation>rozdvojení klon</translation>
    </message>
    <message>
        <source>foliage count density</source>
        <translation>listí počet hustota</translation>
    </message>
    <message>
        <source>envelope crop shape</source>
        <translation>obálka ořez tvar</translation>
    </message>
    <message>
        <source>As an attribute</source>
        <translation>Jako atribut</translation>
    </message>
    <message>
        <source>In the vertex colours</source>
        <translation>V barvách vrcholů</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Zastínění okolím</translation>
    </message>
    <message>
        <source>How much of the sky vertices see, in glTF files: as an attribute _OCCLUSION for shaders, or multiplied into the vertex colours (COLOR_0), which darkens the crown in programs that compute this light themselves.</source>
        <translation>Kolik oblohy vrcholy vidí, v souborech glTF: jako atribut _OCCLUSION pro shadery, nebo vynásobeno do barev vrcholů (COLOR_0), což ztmaví korunu v programech, které toto světlo počítají samy.</translation>
    </message>
    <message>
        <source>%1 cannot hold vertex colours; choose glTF</source>
        <translation>%1 nemůže obsahovat barvy vrcholů; zvolte glTF</translation>
    </message>
    <message>
        <source>the colours of this wind hold the occlusion already</source>
        <translation>barvy tohoto větru už zastínění obsahují</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Osvětlené</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normály</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Drsnost</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Unreal Engine</source>
        <translation>Unreal Engine</translation>
    </message>
    <message>
        <source>Import the LOD0 file, then the others in the mesh editor under Level Of Detail; the pictures of pivots go to the material function PivotPainter2FoliageShader.</source>
        <translation>Importujte soubor LOD0, ostatní pak v editoru sítě pod Level Of Detail; obrázky otočných bodů patří do funkce materiálu PivotPainter2FoliageShader.</translation>
    </message>
    <message>
        <source>Unity</source>
        <translation>Unity</translation>
    </message>
    <message>
        <source>With the package glTFast; put the four objects under one with an LOD Group; the mask maps beside the file belong into the HDRP material.</source>
        <translation>S balíčkem glTFast; čtyři objekty dejte pod jeden s LOD Group; masky vedle souboru patří do materiálu HDRP.</translation>
    </message>
    <message>
        <source>Godot</source>
        <translation>Godot</translation>
    </message>
    <message>
        <source>Give each of the four meshes a visibility range.</source>
        <translation>Každé ze čtyř sítí dejte rozsah viditelnosti.</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>The attribute _OCCLUSION can be mixed into the material.</source>
        <translation>Atribut _OCCLUSION lze přimíchat do materiálu.</translation>
    </message>
    <message>
        <source>three.js</source>
        <translation>three.js</translation>
    </message>
    <message>
        <source>Add the four scenes to one THREE.LOD.</source>
        <translation>Čtyři scény přidejte do jednoho THREE.LOD.</translation>
    </message>
    <message>
        <source>OpenGL: green is up</source>
        <translation>OpenGL: zelená míří nahoru</translation>
    </message>
    <message>
        <source>DirectX: green is down</source>
        <translation>DirectX: zelená míří dolů</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metal</source>
        <translation>Zastínění, drsnost, kov</translation>
    </message>
    <message>
        <source>Unity&apos;s mask map</source>
        <translation>Maska pro Unity</translation>
    </message>
    <message>
        <source>Pixels that a picture may be wide or high: larger ones are halved until they are no larger; 0: as they are. PNG pictures only.</source>
        <translation>Kolik pixelů smí být obrázek široký nebo vysoký: větší se půlí, dokud nejsou dost malé; 0: jak jsou. Jen obrázky PNG.</translation>
    </message>
    <message>
        <source>Normal maps</source>
        <translation>Normálové mapy</translation>
    </message>
    <message>
        <source>Which way the green of normal maps points: up, as OpenGL, Blender, Unity and Godot have it, or down, as DirectX and Unreal.</source>
        <translation>Kam míří zelená v normálových mapách: nahoru, jak ji mají OpenGL, Blender, Unity a Godot, nebo dolů, jako DirectX a Unreal.</translation>
    </message>
    <message>
        <source>Packed maps</source>
        <translation>Sloučené mapy</translation>
    </message>
    <message>
        <source>One picture for several maps: occlusion, roughness and metal in red, green and blue, or Unity&apos;s mask map beside the file (metal, occlusion, detail, smoothness in alpha).</source>
        <translation>Jeden obrázek pro několik map: zastínění, drsnost a kov v červené, zelené a modré, nebo maska pro Unity vedle souboru (kov, zastínění, detail, hladkost v kanálu alfa).</translation>
    </message>
    <message>
        <source>Whether leaves have triangles of their own for their back, for programs that do not draw what is seen from behind.</source>
        <translation>Zda mají listy vlastní trojúhelníky i pro rub, pro programy, které nekreslí to, co je vidět zezadu.</translation>
    </message>
    <message>
        <source>%1 shows leaves from both sides by itself</source>
        <translation>%1 ukazuje listy z obou stran sám</translation>
    </message>
    <message>
        <source>pictures that stay where they are cannot be changed; choose copies</source>
        <translation>obrázky, které zůstávají na místě, nelze změnit; zvolte kopie</translation>
    </message>
    <message>
        <source>Of the full model: 0 is the finest, 1 to 3 have about 50, 12 and 4 % of its triangles.</source>
        <translation>U plného modelu: 0 je nejjemnější, 1 až 3 mají asi 50, 12 a 4 % jeho trojúhelníků.</translation>
    </message>
    <message>
        <source>Babylon.js shows one level of detail at a time, Blender and Godot all four on top of each other, others the finest alone: choose a file for each</source>
        <translation>Babylon.js ukazuje vždy jednu úroveň detailů, Blender a Godot všechny čtyři přes sebe, ostatní jen nejjemnější: zvolte soubor pro každou</translation>
    </message>
    <message>
        <source>No: single faces</source>
        <translation>Ne: jednoduché plochy</translation>
    </message>
    <message>
        <source>Yes: faces for both sides</source>
        <translation>Ano: plochy pro obě strany</translation>
    </message>
    <message>
        <source>Max texture size</source>
        <translation>Max. velikost textury</translation>
    </message>
    <message>
        <source>Two-sided leaves</source>
        <translation>Oboustranné listy</translation>
    </message>
    <message>
        <source>Picture cache</source>
        <translation>Mezipaměť obrázků</translation>
    </message>
    <message>
        <source>%1 holds colours and pivots of the wind, neither attributes nor bones; choose glTF</source>
        <translation>%1 pojme barvy a středy otáčení pro vítr, ne atributy ani kosti; zvolte glTF</translation>
    </message>
    <message>
        <source>%1 files have their pictures inside</source>
        <translation>soubory %1 mají obrázky uvnitř</translation>
    </message>
    <message>
        <source>FBX, binary, centimetres</source>
        <translation>FBX, binární, centimetry</translation>
    </message>
    <message>
        <source>USD, text</source>
        <translation>USD, text</translation>
    </message>
    <message>
        <source>USD, a package with its pictures</source>
        <translation>USD, balíček s obrázky</translation>
    </message>
    <message>
        <source>Comes through (diffuse transmission)</source>
        <translation>Prochází (difuzní propustnost)</translation>
    </message>
    <message>
        <source>As a list of capsules beside the file</source>
        <translation>Jako seznam kapslí vedle souboru</translation>
    </message>
    <message>
        <source>As Unreal looks for it: UCX_…</source>
        <translation>Jak ji hledá Unreal: UCX_…</translation>
    </message>
    <message>
        <source>As Godot looks for it: …-colonly</source>
        <translation>Jak ji hledá Godot: …-colonly</translation>
    </message>
    <message>
        <source>Light through leaves</source>
        <translation>Světlo skrz listy</translation>
    </message>
    <message>
        <source>Of glTF files: leaves with the light behind them are bright (KHR_materials_diffuse_transmission), in programs that know it; others show them as without it.</source>
        <translation>V souborech glTF: listy proti světlu jsou světlé (KHR_materials_diffuse_transmission) v programech, které to znají; ostatní je ukážou jako bez toho.</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Kolize</translation>
    </message>
    <message>
        <source>What things bump into: a capsule for each thick stem, as a list beside the file (JSON), or also as meshes with the names that an engine looks for.</source>
        <translation>Do čeho věci narážejí: kapsle pro každou silnou větev, jako seznam vedle souboru (JSON), nebo také jako sítě s názvy, které engine hledá.</translation>
    </message>
    <message>
        <source>%1 does not know light through leaves; choose glTF</source>
        <translation>%1 nezná světlo skrz listy; zvolte glTF</translation>
    </message>
    <message>
        <source>%1 has no objects whose names an engine looks for; choose glTF or FBX</source>
        <translation>%1 nemá objekty, jejichž názvy by engine hledal; zvolte glTF nebo FBX</translation>
    </message>
    <message>
        <source>collision belongs to one level of detail; choose a file for each</source>
        <translation>kolize patří k jedné úrovni detailu; zvolte soubor pro každou</translation>
    </message>
    <message>
        <source>one solid is its own collision</source>
        <translation>jedno těleso je samo svou kolizí</translation>
    </message>
    <message>
        <source>Arbaro, XML</source>
        <translation>Arbaro, XML</translation>
    </message>
    <message>
        <source>Sapling Tree Gen of Blender, presets</source>
        <translation>Sapling Tree Gen pro Blender, předvolby</translation>
    </message>
    <message>
        <source>tree-gen of Blender, presets</source>
        <translation>tree-gen pro Blender, předvolby</translation>
    </message>
    <message>
        <source>The most that cached textures and thumbnails may take on the disk. The oldest beyond it are removed.</source>
        <translation>Kolik nejvýše smějí textury a náhledy v mezipaměti zabrat na disku. Nejstarší nad to se odstraní.</translation>
    </message>
    <message>
        <source>displacement needs the heights of the bark: a recipe, or beside its picture %1</source>
        <translation>vytlačení potřebuje výšky kůry: recept, nebo vedle jejího obrázku %1</translation>
    </message>
    <message>
        <source>cannot write %1: there is no folder %2</source>
        <translation>nelze zapsat %1: složka %2 neexistuje</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to export</source>
        <translation>strom je prázdný, není co exportovat</translation>
    </message>
    <message>
        <source>one solid does not move in the wind</source>
        <translation>jedno těleso se ve větru nehýbe</translation>
    </message>
    <message>
        <source>there is no choice &apos;%1&apos;</source>
        <translation>volba „%1“ neexistuje</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is one of %2, not &apos;%3&apos;</source>
        <translation>„%1“ je jedno z %2, ne „%3“</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number without decimals</source>
        <translation>„%1“: „%2“ není celé číslo</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>„%1“: „%2“ není číslo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is between %2 and %3, not %4</source>
        <translation>„%1“ je mezi %2 a %3, ne %4</translation>
    </message>
    <message>
        <source>the name of the model file has no ending; it says the format: %1</source>
        <translation>název souboru modelu nemá příponu; ta určuje formát: %1</translation>
    </message>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>„%1“ nelze zapsat</translation>
    </message>
    <message>
        <source>this is no XML: %1</source>
        <translation>toto není XML: %1</translation>
    </message>
    <message>
        <source>there is no &lt;arbaro&gt; with a &lt;species&gt;</source>
        <translation>chybí &lt;arbaro&gt; s prvkem &lt;species&gt;</translation>
    </message>
    <message>
        <source>a &lt;param&gt; has a name and a value</source>
        <translation>&lt;param&gt; má mít name a value</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known and left out</source>
        <translation>„%1“ není známo a vynechá se</translation>
    </message>
    <message>
        <source>&apos;%1&apos; wants a number, not &apos;%2&apos;; it is left out</source>
        <translation>„%1“ má být číslo, ne „%2“; vynechá se</translation>
    </message>
    <message>
        <source>%1 is %2: %3 is out of its range</source>
        <translation>%1 je %2: %3 je mimo rozsah</translation>
    </message>
    <message>
        <source>these are no values of a tree that is known here</source>
        <translation>toto nejsou hodnoty žádného zde známého stromu</translation>
    </message>
    <message>
        <source>%1: a file of more than 1 MB is no preset of a tree</source>
        <translation>%1: soubor větší než 1 MB není předvolba stromu</translation>
    </message>
    <message>
        <source>a dictionary {…} with the values of a tree is wanted here</source>
        <translation>zde má být slovník {…} s hodnotami stromu</translation>
    </message>
    <message>
        <source>nothing but comments may follow the values</source>
        <translation>po hodnotách smějí následovat jen komentáře</translation>
    </message>
    <message>
        <source>&apos;=&apos; is wanted behind the name</source>
        <translation>za názvem má být „=“</translation>
    </message>
    <message>
        <source>this text is not closed</source>
        <translation>tento text není ukončen</translation>
    </message>
    <message>
        <source>a value is wanted here</source>
        <translation>zde má být hodnota</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value: only numbers, texts, True, False, None and lists are read</source>
        <translation>„%1“ není hodnota: čtou se jen čísla, texty, True, False, None a seznamy</translation>
    </message>
    <message>
        <source>&apos;%1&apos; or &apos;%2&apos; is wanted here</source>
        <translation>zde má být „%1“ nebo „%2“</translation>
    </message>
    <message>
        <source>lists are nested too deep</source>
        <translation>seznamy jsou vnořeny příliš hluboko</translation>
    </message>
    <message>
        <source>this list is too long</source>
        <translation>tento seznam je příliš dlouhý</translation>
    </message>
    <message>
        <source>dictionaries are nested too deep</source>
        <translation>slovníky jsou vnořeny příliš hluboko</translation>
    </message>
    <message>
        <source>a name in quotes is wanted here</source>
        <translation>zde má být název v uvozovkách</translation>
    </message>
    <message>
        <source>&apos;:&apos; is wanted here</source>
        <translation>zde má být „:“</translation>
    </message>
    <message>
        <source>is too large: a leaf may have at most %1 vertices</source>
        <translation>je příliš velký: list smí mít nejvýše %1 vrcholů</translation>
    </message>
    <message>
        <source>is neither .obj nor .glb</source>
        <translation>není .obj ani .glb</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>nelze přečíst: %1</translation>
    </message>
    <message>
        <source>is no .glb with a mesh, or too large for a leaf</source>
        <translation>není .glb se sítí, nebo je na list příliš velký</translation>
    </message>
    <message>
        <source>is no mesh that can be read: %1</source>
        <translation>není síť, kterou lze přečíst: %1</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>nemá trojúhelníky</translation>
    </message>
    <message>
        <source>displacement in cells of %1 m would make more than %2 million triangles; choose larger cells</source>
        <translation>vytlačení v buňkách po %1 m by vytvořilo více než %2 milionu trojúhelníků; zvolte větší buňky</translation>
    </message>
    <message>
        <source>there is no %1; there are %2</source>
        <translation>%1 neexistuje; existují %2</translation>
    </message>
    <message>
        <source>has no length or no width</source>
        <translation>nemá délku nebo šířku</translation>
    </message>
    <message>
        <source>a solid of %1 million voxels is too large; voxels of %2 m would do</source>
        <translation>těleso z %1 milionu voxelů je příliš velké; stačily by voxely %2 m</translation>
    </message>
    <message>
        <source>the tree has %1 stems; a solid is made of %2 at most (fewer Levels or Branches)</source>
        <translation>strom má %1 větví; těleso se dělá nejvýše z %2 (méně úrovní nebo větví)</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to make a solid of</source>
        <translation>strom je prázdný, těleso není z čeho udělat</translation>
    </message>
    <message>
        <source>point %1 is empty</source>
        <translation>bod %1 je prázdný</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) is not x:y</source>
        <translation>bod %1 („%2“) není x:y</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has a y that is no number</source>
        <translation>bod %1 („%2“) má y, které není číslo</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has an x that is no number</source>
        <translation>bod %1 („%2“) má x, které není číslo</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) must lie to the right of the point before it</source>
        <translation>bod %1 („%2“) musí ležet vpravo od předchozího</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>křivka má nejvýše %1 bodů</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 nemá hodnotu</translation>
    </message>
    <message>
        <source>%1 is not a number: &apos;%2&apos;</source>
        <translation>%1 není číslo: „%2“</translation>
    </message>
    <message>
        <source>%1 has no choice &apos;%2&apos;</source>
        <translation>%1 nemá volbu „%2“</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 musí být celé číslo, ne %2</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, not %4; taken as %5</source>
        <translation>%1 musí být od %2 do %3, ne %4; vzato jako %5</translation>
    </message>
    <message>
        <source>%1: the %2 of point %3 must be from %4 to %5, not %6; taken as the nearest</source>
        <translation>%1: %2 bodu %3 musí být od %4 do %5, ne %6; vzato nejbližší</translation>
    </message>
    <message>
        <source>%1 must not hold a line of three quotes: it would end the text in a file</source>
        <translation>%1 nesmí obsahovat řádek tří uvozovek: ukončil by text v souboru</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>známé: %1</translation>
    </message>
    <message>
        <source>this is a binary tree of the program Kraut, which uses the same file ending; it cannot be read here</source>
        <translation>toto je binární strom programu Kraut, který má stejnou příponu; zde ho nelze přečíst</translation>
    </message>
    <message>
        <source>this is UTF-16 text; save it as UTF-8</source>
        <translation>toto je text v UTF-16; uložte ho v UTF-8</translation>
    </message>
    <message>
        <source>this is not a text file of parameters</source>
        <translation>toto není textový soubor parametrů</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>soubor je prázdný</translation>
    </message>
    <message>
        <source>this version cannot grow trees by the method &apos;%1&apos;</source>
        <translation>tato verze neumí pěstovat stromy metodou „%1“</translation>
    </message>
    <message>
        <source>no line %1; read as format %2</source>
        <translation>chybí řádek %1; čteno jako formát %2</translation>
    </message>
    <message>
        <source>a file with the method &apos;%1&apos; says %2</source>
        <translation>soubor s metodou „%1“ uvádí %2</translation>
    </message>
    <message>
        <source>the text is not closed: a line of three quotes is missing</source>
        <translation>text není ukončen: chybí řádek tří uvozovek</translation>
    </message>
    <message>
        <source>this character is not UTF-8</source>
        <translation>tento znak není UTF-8</translation>
    </message>
    <message>
        <source>this line is not &apos;Key = Value&apos;</source>
        <translation>tento řádek není „Klíč = Hodnota“</translation>
    </message>
    <message>
        <source>the quote is not closed</source>
        <translation>uvozovka není uzavřena</translation>
    </message>
    <message>
        <source>nothing but a comment may follow the closing quote</source>
        <translation>po koncové uvozovce smí následovat jen komentář</translation>
    </message>
    <message>
        <source>there is no key in front of &apos;=&apos;</source>
        <translation>před „=“ chybí klíč</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos; is kept</source>
        <translation>neznámý klíč „%1“ se zachová</translation>
    </message>
    <message>
        <source>Format must be a whole number from 1, not &apos;%1&apos;</source>
        <translation>Format musí být celé číslo od 1, ne „%1“</translation>
    </message>
    <message>
        <source>the file has format %1, but this version reads only up to %2; a newer Stromar is needed</source>
        <translation>soubor má formát %1, tato verze však čte jen po %2; je třeba novější Stromar</translation>
    </message>
    <message>
        <source>a second value for %1; the first is in line %2</source>
        <translation>druhá hodnota pro %1; první je na řádku %2</translation>
    </message>
    <message>
        <source>this is a folder, not a .tree file</source>
        <translation>toto je složka, ne soubor .tree</translation>
    </message>
    <message>
        <source>a backdrop is a picture, .png or .jpg, or a panorama, .hdr: not %1</source>
        <translation>pozadí je obrázek .png nebo .jpg, nebo panorama .hdr: ne %1</translation>
    </message>
    <message>
        <source>cannot read the backdrop %1</source>
        <translation>pozadí %1 nelze přečíst</translation>
    </message>
    <message>
        <source>this grammar makes %1 modules in %2 derivations; at most %3 are allowed</source>
        <translation>tato gramatika vytvoří %1 modulů v %2 odvozeních; povoleno je nejvýše %3</translation>
    </message>
    <message>
        <source>the grammar draws nothing: its word has no F with a length after %1 derivations</source>
        <translation>gramatika nic nekreslí: její slovo po %1 odvozeních nemá žádné F s délkou</translation>
    </message>
    <message>
        <source>this expression is nested too deeply</source>
        <translation>tento výraz je vnořen příliš hluboko</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not defined here</source>
        <translation>„%1“ zde není definováno</translation>
    </message>
    <message>
        <source>there is no function &apos;%1&apos;</source>
        <translation>funkce „%1“ neexistuje</translation>
    </message>
    <message>
        <source>%1() takes %2 number, not %3</source>
        <translation>%1() bere %2 číslo, ne %3</translation>
    </message>
    <message>
        <source>%1() takes %2 numbers, not %3</source>
        <translation>%1() bere %2 čísla, ne %3</translation>
    </message>
    <message>
        <source>this is no finite number</source>
        <translation>toto není konečné číslo</translation>
    </message>
    <message>
        <source>this comment has no end</source>
        <translation>tento komentář nemá konec</translation>
    </message>
    <message>
        <source>expected &apos;%1&apos;</source>
        <translation>očekáváno „%1“</translation>
    </message>
    <message>
        <source>this bracket is not closed</source>
        <translation>tato závorka není uzavřena</translation>
    </message>
    <message>
        <source>a number is missing here</source>
        <translation>zde chybí číslo</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>toto není číslo</translation>
    </message>
    <message>
        <source>the bracket of this call is not closed</source>
        <translation>závorka tohoto volání není uzavřena</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>„%1“ není číslo</translation>
    </message>
    <message>
        <source>the axiom is missing: axiom: …</source>
        <translation>chybí axiom: axiom: …</translation>
    </message>
    <message>
        <source>only #define and #ignore are known</source>
        <translation>známé jsou jen #define a #ignore</translation>
    </message>
    <message>
        <source>the number of derivations is the value Derivations, not a line of the grammar</source>
        <translation>počet odvození je hodnota Derivations, ne řádek gramatiky</translation>
    </message>
    <message>
        <source>there is an axiom already</source>
        <translation>axiom už zde je</translation>
    </message>
    <message>
        <source>the axiom is empty</source>
        <translation>axiom je prázdný</translation>
    </message>
    <message>
        <source>#define needs a name</source>
        <translation>#define potřebuje název</translation>
    </message>
    <message>
        <source>nothing may follow the value</source>
        <translation>za hodnotou nesmí nic následovat</translation>
    </message>
    <message>
        <source>a value that is defined cannot depend on chance</source>
        <translation>definovaná hodnota nemůže záviset na náhodě</translation>
    </message>
    <message>
        <source>polygons { . } are not supported; use ~L for a leaf</source>
        <translation>mnohoúhelníky { . } nejsou podporovány; pro list použijte ~L</translation>
    </message>
    <message>
        <source>after ~ stands L (leaf), B (blossom) or K (fruit)</source>
        <translation>za ~ stojí L (list), B (květ) nebo K (plod)</translation>
    </message>
    <message>
        <source>a letter is missing here</source>
        <translation>zde chybí písmeno</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no letter of a word</source>
        <translation>„%1“ není písmeno slova</translation>
    </message>
    <message>
        <source>the bracket of this module&apos;s numbers is not closed</source>
        <translation>závorka čísel tohoto modulu není uzavřena</translation>
    </message>
    <message>
        <source>there is no [ for this ]</source>
        <translation>k této ] chybí [</translation>
    </message>
    <message>
        <source>there is no ] for this [</source>
        <translation>k této [ chybí ]</translation>
    </message>
    <message>
        <source>here stands the name of a parameter</source>
        <translation>zde má být název parametru</translation>
    </message>
    <message>
        <source>expected &apos;)&apos; after the parameters</source>
        <translation>za parametry očekávána „)“</translation>
    </message>
    <message>
        <source>a production rewrites one module: A(x) : condition -&gt; successor</source>
        <translation>pravidlo přepisuje jeden modul: A(x) : podmínka -&gt; následník</translation>
    </message>
    <message>
        <source>a production has at most 32 parameters</source>
        <translation>pravidlo má nejvýše 32 parametrů</translation>
    </message>
    <message>
        <source>brackets in a context are not supported</source>
        <translation>závorky v kontextu nejsou podporovány</translation>
    </message>
    <message>
        <source>expected &apos;-&gt;&apos;</source>
        <translation>očekáváno „-&gt;“</translation>
    </message>
    <message>
        <source>this production never matches: no word has %1 with %2 numbers</source>
        <translation>toto pravidlo se nikdy nepoužije: žádné slovo nemá %1 s počtem čísel %2</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 modules</source>
        <translation>slovo této gramatiky by mělo více než %1 modulů</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 numbers</source>
        <translation>slovo této gramatiky by mělo více než %1 čísel</translation>
    </message>
    <message>
        <source>a number of %1 is not finite when %2 is rewritten</source>
        <translation>číslo modulu %1 není konečné při přepisu %2</translation>
    </message>
    <message>
        <source>error</source>
        <translation>chyba</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>varování</translation>
    </message>
    <message>
        <source>cannot write %1</source>
        <translation>nelze zapsat %1</translation>
    </message>
    <message>
        <source>cannot write %1: the file on the disk is incomplete</source>
        <translation>nelze zapsat %1: soubor na disku není úplný</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>nelze přečíst %1</translation>
    </message>
    <message>
        <source>, did you mean &apos;%1&apos;?</source>
        <translation>, mysleli jste „%1“?</translation>
    </message>
    <message>
        <source>as they are</source>
        <translation>jak jsou</translation>
    </message>
    <message>
        <source>a row of trees has a file for each level of detail; choose that or one level</source>
        <translation>řada stromů má pro každou úroveň detailu soubor; zvolte to, nebo jednu úroveň</translation>
    </message>
    <message>
        <source>a row of trees stands still; choose one tree or no wind</source>
        <translation>řada stromů stojí v bezvětří; zvolte jeden strom, nebo žádný vítr</translation>
    </message>
    <message>
        <source>a row of trees has no collision; choose one tree or none</source>
        <translation>řada stromů nemá kolize; zvolte jeden strom, nebo žádné</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automaticky</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nikdy</translation>
    </message>
    <message>
        <source>Sun colour</source>
        <translation>Barva slunce</translation>
    </message>
    <message>
        <source>Sky colour</source>
        <translation>Barva oblohy</translation>
    </message>
    <message>
        <source>leaves are spread along their stem as in the paper</source>
        <translation>listy jsou na větvi rozloženy jako v článku</translation>
    </message>
    <message>
        <source>there it roughens the mesh of the trunk</source>
        <translation>tam zdrsňuje síť kmene</translation>
    </message>
    <message>
        <source>trunks lean by TrunksLean</source>
        <translation>kmeny se naklánějí podle TrunksLean</translation>
    </message>
    <message>
        <source>trunks are turned by chance</source>
        <translation>kmeny jsou natočeny náhodně</translation>
    </message>
    <message>
        <source>of its shapes of discs and spheres an oval leaf is nearest</source>
        <translation>z jeho kotoučů a koulí je nejblíže oválný list</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be had: %2</source>
        <translation>„%1“ nelze převzít: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; becomes %2 = %3: %4</source>
        <translation>„%1“ se mění na %2 = %3: %4</translation>
    </message>
    <message>
        <source>its shapes 8 and 10 have no formula here; the nearest is a tapered cylinder</source>
        <translation>jeho tvary 8 a 10 zde nemají vzorec; nejblíže je zúžený válec</translation>
    </message>
    <message>
        <source>branches have no bare base here</source>
        <translation>větve zde nemají holou část</translation>
    </message>
    <message>
        <source>the trunk splits from its first segment on</source>
        <translation>kmen se dělí od prvního dílu</translation>
    </message>
    <message>
        <source>splits are spread evenly</source>
        <translation>rozdvojení jsou rozložena rovnoměrně</translation>
    </message>
    <message>
        <source>branches are as thick as RatioPower says</source>
        <translation>větve jsou tak silné, jak říká RatioPower</translation>
    </message>
    <message>
        <source>branches are not drawn outwards here</source>
        <translation>větve se zde netáhnou ven</translation>
    </message>
    <message>
        <source>branches are spread evenly along the trunk</source>
        <translation>větve jsou po kmeni rozloženy rovnoměrně</translation>
    </message>
    <message>
        <source>rings of branches are Whorl here</source>
        <translation>kruhy větví jsou zde Whorl</translation>
    </message>
    <message>
        <source>the trunk does not thin towards branches</source>
        <translation>kmen se k větvím nezužuje</translation>
    </message>
    <message>
        <source>the envelope ends at the crown&apos;s base</source>
        <translation>obálka končí u základny koruny</translation>
    </message>
    <message>
        <source>leaves of a stem are equally large</source>
        <translation>listy jedné větve jsou stejně velké</translation>
    </message>
    <message>
        <source>leaves turn to the light by LeafBend</source>
        <translation>listy se ke světlu natáčejí podle LeafBend</translation>
    </message>
    <message>
        <source>a negative number there is a random one</source>
        <translation>záporné číslo tam znamená náhodné</translation>
    </message>
    <message>
        <source>stems bend by CurveV</source>
        <translation>stonky se ohýbají podle CurveV</translation>
    </message>
    <message>
        <source>whorls are counted by their branches, and between alternate and opposite there is nothing</source>
        <translation>přesleny se počítají po větvích a mezi střídavými a vstřícnými není nic</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Komprese</translation>
    </message>
    <message>
        <source>%1 cannot be compressed; choose glTF</source>
        <translation>%1 nelze komprimovat; zvolte glTF</translation>
    </message>
    <message>
        <source>what moves in the wind cannot be compressed</source>
        <translation>co se hýbe ve větru, nelze komprimovat</translation>
    </message>
    <message>
        <source>Quantised (KHR_mesh_quantization)</source>
        <translation>Kvantováno (KHR_mesh_quantization)</translation>
    </message>
    <message>
        <source>Quantised, then meshopt (EXT_meshopt_compression)</source>
        <translation>Kvantováno, pak meshopt (EXT_meshopt_compression)</translation>
    </message>
    <message>
        <source>Of glTF files: vertices in 16 and 8 bits, which most programs read, or these compressed by meshoptimizer as well, for web pages whose loader has its decoder.</source>
        <translation>Soubory glTF: vrcholy v 16 a 8 bitech, které čte většina programů, nebo navíc komprimované meshoptimizerem, pro webové stránky, jejichž načítač má jeho dekodér.</translation>
    </message>
    <message>
        <source>leaves that move in the wind cannot be instances</source>
        <translation>listy, které se hýbou ve větru, nemohou být instancemi</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instance</translation>
    </message>
    <message>
        <source>instances belong to one level of detail; choose a file for each</source>
        <translation>instance patří k jedné úrovni detailů; zvolte soubor pro každou</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>JPEG where it can be</source>
        <translation>JPEG, kde to jde</translation>
    </message>
    <message>
        <source>Texture format</source>
        <translation>Formát textur</translation>
    </message>
    <message>
        <source>What pictures of bark colours are written as: JPEG has about a fifth of the bytes. Pictures with alpha, normals and roughness stay PNG.</source>
        <translation>V čem se zapisují barvy kůry: JPEG má asi pětinu bajtů. Obrázky s alfou, normály a drsnost zůstávají PNG.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekty</translation>
    </message>
    <message>
        <source>Texture atlas</source>
        <translation>Atlas textur</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiály</translation>
    </message>
    <message>
        <source>texture coordinates</source>
        <translation>souřadnice textury</translation>
    </message>
    <message>
        <source>normals (programs make their own)</source>
        <translation>normály (programy si počítají vlastní)</translation>
    </message>
    <message>
        <source>tangents</source>
        <translation>tečny</translation>
    </message>
    <message>
        <source>Blender and Godot do not read where leaves are transparent</source>
        <translation>Blender a Godot nečtou, kde jsou listy průhledné</translation>
    </message>
    <message>
        <source>all stems and leaves are one mesh</source>
        <translation>všechny větve a listy jsou jedna síť</translation>
    </message>
    <message>
        <source>names end after ten letters; large meshes are cut into parts</source>
        <translation>jména končí po deseti písmenech; velké sítě jsou rozděleny na části</translation>
    </message>
    <message>
        <source>a camera, lights and ground are added</source>
        <translation>přidána je kamera, světla a zem</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose no atlas, or level of detail 0 or 1</source>
        <translation>karty rostoucího stromu ukazují v každém snímku jinou větvičku; zvolte export bez atlasu nebo úroveň detailu 0 či 1</translation>
    </message>
    <message>
        <source>Of glTF and USD files: one mesh for all leaves of a kind and a list of places instead of a copy for each, for programs that know it (EXT_mesh_gpu_instancing, PointInstancer). Normals are not rounded, and each leaf has one tint.</source>
        <translation>Pro soubory glTF a USD: jedna síť pro všechny listy jednoho druhu a seznam míst místo kopie pro každý, pro programy, které to znají (EXT_mesh_gpu_instancing, PointInstancer). Normály nejsou zaoblené a každý list má jeden odstín.</translation>
    </message>
    <message>
        <source>Levels of detail are variants of the set LOD, which three.js does not read: choose a file for each</source>
        <translation>Úrovně detailu jsou varianty sady LOD, které three.js nečte: zvolte soubor pro každou</translation>
    </message>
    <message>
        <source>%1 cannot hold instances; choose glTF or USD</source>
        <translation>%1 nemůže obsahovat instance; zvolte glTF nebo USD</translation>
    </message>
    <message>
        <source>only PNG textures can go into an atlas, not %1</source>
        <translation>do atlasu mohou jen textury PNG, ne %1</translation>
    </message>
    <message>
        <source>%1 repeats its texture (texture coordinates beyond 0 to 1), which an atlas cannot do</source>
        <translation>%1 opakuje svou texturu (souřadnice textury mimo 0 až 1), to atlas neumí</translation>
    </message>
    <message>
        <source>By branch level</source>
        <translation>Podle úrovně větví</translation>
    </message>
    <message>
        <source>By material</source>
        <translation>Podle materiálu</translation>
    </message>
    <message>
        <source>Leaves, blossoms and twigs</source>
        <translation>Listy, květy a větvičky</translation>
    </message>
    <message>
        <source>Separate objects for trunk, branches and leaves, or one object per material: fewer draw calls.</source>
        <translation>Samostatné objekty pro kmen, větve a listy, nebo jeden objekt na materiál: méně vykreslovacích volání.</translation>
    </message>
    <message>
        <source>One material and one texture for leaves, blossoms and twigs: fewer draw calls. PNG textures only.</source>
        <translation>Jeden materiál a jedna textura pro listy, květy a větvičky: méně vykreslovacích volání. Jen textury PNG.</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no atlas</source>
        <translation>%1 neobsahuje textury, tedy ani atlas</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>textury</translation>
    </message>
    <message>
        <source>opacity of leaves</source>
        <translation>krytí listů</translation>
    </message>
    <message>
        <source>normal maps</source>
        <translation>normálové mapy</translation>
    </message>
    <message>
        <source>roughness maps</source>
        <translation>mapy drsnosti</translation>
    </message>
    <message>
        <source>leaf tints</source>
        <translation>odstíny listů</translation>
    </message>
    <message>
        <source>ambient occlusion (attribute)</source>
        <translation>okolní zastínění (atribut)</translation>
    </message>
    <message>
        <source>the roughness maps lie beside the file</source>
        <translation>mapy drsnosti leží vedle souboru</translation>
    </message>
    <message>
        <source>frames of a motion have no impostor; choose one tree or none</source>
        <translation>snímky pohybu nemají impostor; zvolte jeden strom nebo žádný</translation>
    </message>
    <message>
        <source>Cross of billboards</source>
        <translation>Křížené billboardy</translation>
    </message>
    <message>
        <source>Views from above the horizon (hemi-octahedral)</source>
        <translation>Pohledy nad obzorem (hemioktaedr)</translation>
    </message>
    <message>
        <source>Views from all sides (octahedral)</source>
        <translation>Pohledy ze všech stran (oktaedr)</translation>
    </message>
    <message>
        <source>Impostor</source>
        <translation>Impostor</translation>
    </message>
    <message>
        <source>What stands for the tree when it is far: two crossed billboards as the last level of detail, or 8 × 8 views in an atlas beside the model (albedo, normal, depth), for a shader that shows the nearest.</source>
        <translation>Co zastupuje strom v dálce: dva křížené billboardy jako poslední úroveň detailů, nebo 8 × 8 pohledů v atlasu vedle modelu (barva, normály, hloubka) pro shader, který ukáže ty nejbližší.</translation>
    </message>
    <message>
        <source>one solid has no impostor</source>
        <translation>jediné těleso nemá impostor</translation>
    </message>
    <message>
        <source>crossed billboards are the last level of detail; choose all levels of detail</source>
        <translation>křížené billboardy jsou poslední úrovní detailů; zvolte všechny úrovně detailů</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no billboards</source>
        <translation>%1 nenese textury, tedy ani billboardy</translation>
    </message>
    <message>
        <source>a row of trees has no impostor; choose one tree or none</source>
        <translation>řada stromů nemá impostor; zvolte jeden strom nebo žádný</translation>
    </message>
    <message>
        <source>an impostor can be made of PNG textures only, not of %1</source>
        <translation>impostor lze vytvořit jen z textur PNG, ne z %1</translation>
    </message>
    <message>
        <source>Without overlap, for light maps</source>
        <translation>Bez překryvů, pro světelné mapy</translation>
    </message>
    <message>
        <source>Second UV</source>
        <translation>Druhé UV</translation>
    </message>
    <message>
        <source>A second set of texture coordinates, in which no two triangles share a place: for light maps, in glTF and FBX files.</source>
        <translation>Druhá sada souřadnic textury, v níž žádné dva trojúhelníky nesdílejí místo: pro světelné mapy, v souborech glTF a FBX.</translation>
    </message>
    <message>
        <source>%1 holds one set of texture coordinates; choose glTF or FBX</source>
        <translation>%1 obsahuje jednu sadu souřadnic textury; zvolte glTF nebo FBX</translation>
    </message>
    <message>
        <source>one solid has no texture coordinates</source>
        <translation>jedno těleso nemá souřadnice textury</translation>
    </message>
    <message>
        <source>the second texture coordinates hold the wind already</source>
        <translation>druhé souřadnice textury už obsahují vítr</translation>
    </message>
    <message>
        <source>instances share their texture coordinates</source>
        <translation>instance sdílejí souřadnice textury</translation>
    </message>
    <message>
        <source>instances (PointInstancer), levels of detail in one file (variants) and time samples are for programs that are built on OpenUSD: three.js shows none of them</source>
        <translation>instance (PointInstancer), úrovně detailů v jednom souboru (varianty) a časové vzorky jsou pro programy postavené na OpenUSD: three.js nezobrazuje nic z toho</translation>
    </message>
    <message>
        <source>%1 holds no time samples; choose USD</source>
        <translation>%1 neobsahuje časové vzorky; zvolte USD</translation>
    </message>
    <message>
        <source>time samples belong to one level of detail; choose a file for each</source>
        <translation>časové vzorky patří k jedné úrovni detailů; zvolte pro každou soubor</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose level of detail 0 or 1</source>
        <translation>karty rostoucího stromu ukazují v každém snímku jinou větvičku; zvolte úroveň detailů 0 nebo 1</translation>
    </message>
</context>
<context>
    <name>stromar::CComparison</name>
    <message>
        <source>Kept; A shows it in place of what you make of it</source>
        <translation>Uchováno; klávesa A ho ukáže místo toho, co z něj uděláte</translation>
    </message>
    <message>
        <source>Nothing was kept yet: Shift+A keeps the tree as it is</source>
        <translation>Zatím není nic uchováno: Shift+A uchová strom, jaký je</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Předtím</translation>
    </message>
</context>
<context>
    <name>stromar::CCurveEditor</name>
    <message>
        <source>value</source>
        <translation>hodnota</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>&amp;Smazat bod</translation>
    </message>
</context>
<context>
    <name>stromar::CDockFolder</name>
    <message>
        <source>Folded docks</source>
        <translation>Složené panely</translation>
    </message>
</context>
<context>
    <name>stromar::CDocument</name>
    <message>
        <source>new.tree</source>
        <translation>nový.tree</translation>
    </message>
    <message>
        <source>Open preset %1</source>
        <translation>Otevřít předvolbu %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Obnovit</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Import %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportController</name>
    <message>
        <source>Writing %1</source>
        <translation>Zapisuje se %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Cannot export the tree</source>
        <translation>Strom nelze exportovat</translation>
    </message>
    <message>
        <source>Export cancelled; no file was changed</source>
        <translation>Export zrušen; žádný soubor se nezměnil</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Exportováno %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Lost in this format</source>
        <translation>V tomto formátu se ztratí</translation>
    </message>
    <message>
        <source>Size, about</source>
        <translation>Velikost asi</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Procházet…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Where to export</source>
        <translation>Kam exportovat</translation>
    </message>
    <message>
        <source>The file&apos;s name has to end in %1</source>
        <translation>Název souboru musí končit na %1</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 už existuje. Nahradit?</translation>
    </message>
    <message>
        <source>%1, and what displacement adds</source>
        <translation>%1 a to, co přidá posunutí povrchu</translation>
    </message>
    <message>
        <source>No program in particular</source>
        <translation>Žádný určitý program</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Načíst…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Uložit…</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Pro</translation>
    </message>
    <message>
        <source>Load Export Settings</source>
        <translation>Načíst nastavení exportu</translation>
    </message>
    <message>
        <source>Export settings (*.export)</source>
        <translation>Nastavení exportu (*.export)</translation>
    </message>
    <message>
        <source>Cannot load the settings</source>
        <translation>Nastavení nelze načíst</translation>
    </message>
    <message>
        <source>Save Export Settings</source>
        <translation>Uložit nastavení exportu</translation>
    </message>
    <message>
        <source>Cannot save the settings</source>
        <translation>Nastavení nelze uložit</translation>
    </message>
    <message>
        <source>This tree alone</source>
        <translation>Jen tento strom</translation>
    </message>
    <message>
        <source>All %1 side by side, as one scene</source>
        <translation>Všech %1 vedle sebe jako jedna scéna</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Stromy</translation>
    </message>
</context>
<context>
    <name>stromar::CFallController</name>
    <message>
        <source>Fell the tree</source>
        <translation>Pokácet strom</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Where it falls to: 0 to the right, 90 away from the front</source>
        <translation>Kam padne: 0 doprava, 90 dozadu</translation>
    </message>
    <message>
        <source>Of the cut above the ground; 0 fells it with its foot</source>
        <translation>Výška řezu nad zemí; 0 skácí strom i s patou</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>S&amp;měr</translation>
    </message>
    <message>
        <source>&amp;Height of the cut</source>
        <translation>&amp;Výška řezu</translation>
    </message>
    <message>
        <source>&amp;Fell</source>
        <translation>&amp;Pokácet</translation>
    </message>
</context>
<context>
    <name>stromar::CFileController</name>
    <message>
        <source>Trees (*.tree);;All files (*)</source>
        <translation>Stromy (*.tree);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Autosave: %1</source>
        <translation>Průběžné ukládání: %1</translation>
    </message>
    <message>
        <source>Cannot open the tree</source>
        <translation>Strom nelze otevřít</translation>
    </message>
    <message>
        <source>Cannot open the preset</source>
        <translation>Předvolbu nelze otevřít</translation>
    </message>
    <message>
        <source>Cannot save the tree</source>
        <translation>Strom nelze uložit</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Uloženo %1</translation>
    </message>
    <message>
        <source>Open a tree</source>
        <translation>Otevřít strom</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Uložit strom</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Uložit jako předvolbu</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Název předvolby</translation>
    </message>
    <message>
        <source>Replace the preset “%1”?</source>
        <translation>Nahradit předvolbu „%1“?</translation>
    </message>
    <message>
        <source>Cannot save the preset</source>
        <translation>Předvolbu nelze uložit</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)</source>
        <translation>Obrázky (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>As the &amp;bark</source>
        <translation>Jako &amp;kůra</translation>
    </message>
    <message>
        <source>As the &amp;leaf</source>
        <translation>Jako &amp;list</translation>
    </message>
    <message>
        <source>Another program has changed %1. Opening it again loses your changes.</source>
        <translation>Jiný program změnil %1. Novým otevřením ztratíte své změny.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Jiný program změnil %1.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Otevřít znovu</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Nechat moje</translation>
    </message>
    <message>
        <source>A tree that was never saved</source>
        <translation>Strom, který nebyl nikdy uložen</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Obnovit neuložené změny</translation>
    </message>
    <message>
        <source>Stromar ended without saving these changes of %1:
%2</source>
        <translation>Stromar skončil bez uložení těchto změn z %1:
%2</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Obnovit</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Zahodit</translation>
    </message>
    <message>
        <source>Ask &amp;Later</source>
        <translation>Zeptat se &amp;později</translation>
    </message>
    <message>
        <source>Cannot restore</source>
        <translation>Nelze obnovit</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Uložit změny v %1?</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.glb);;All files (*)</source>
        <translation>Sítě (*.obj *.glb);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Changes from before a preset was opened are not saved; Undo brings them back. Go on without them?</source>
        <translation>Změny z doby před otevřením předvolby nejsou uloženy; Zpět je vrátí. Pokračovat bez nich?</translation>
    </message>
    <message>
        <source>Cannot open the workshop</source>
        <translation>Dílnu nelze otevřít</translation>
    </message>
    <message>
        <source>Cannot import the tree</source>
        <translation>Strom nelze importovat</translation>
    </message>
    <message>
        <source>Trees of other programs</source>
        <translation>Stromy jiných programů</translation>
    </message>
    <message>
        <source>Import a tree</source>
        <translation>Importovat strom</translation>
    </message>
</context>
<context>
    <name>stromar::CGrowthController</name>
    <message>
        <source>%1 = %2 fits</source>
        <translation>%1 = %2 se vejde</translation>
    </message>
    <message>
        <source>Grow it anyway</source>
        <translation>Přesto vypěstovat</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <source>Nothing has grown: this tree may have up to %1 stems, %2 leaves and %3 million vertices and take %4 GB of memory; the limit is %5 million vertices and %6 GB.</source>
        <translation>Nic nevyrostlo: tento strom může mít až %1 větví, %2 listů a %3 milionů vrcholů a zabrat %4 GB paměti; mez je %5 milionů vrcholů a %6 GB.</translation>
    </message>
</context>
<context>
    <name>stromar::CHelpWindow</name>
    <message>
        <source>Stromar Manual</source>
        <translation>Příručka Stromaru</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vpřed</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Obsah</translation>
    </message>
</context>
<context>
    <name>stromar::CLanguageEditor</name>
    <message>
        <source>What is wrong</source>
        <translation>Co je špatně</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Najít</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importovat…</translation>
    </message>
    <message>
        <source>Take the text of a file</source>
        <translation>Vzít text ze souboru</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportovat…</translation>
    </message>
    <message>
        <source>Write the text to a file of its own</source>
        <translation>Zapsat text do vlastního souboru</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Odpojit</translation>
    </message>
    <message>
        <source>Show the editor in a window of its own, or back in its tab</source>
        <translation>Ukázat editor ve vlastním okně, nebo zpět v kartě</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>The word after this step</source>
        <translation>Slovo po tomto kroku</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> z %1</translation>
    </message>
    <message>
        <source>Import a Text</source>
        <translation>Importovat text</translation>
    </message>
    <message>
        <source>Cannot import the text</source>
        <translation>Text nelze importovat</translation>
    </message>
    <message>
        <source>Export the Text</source>
        <translation>Exportovat text</translation>
    </message>
    <message>
        <source>Cannot export the text</source>
        <translation>Text nelze exportovat</translation>
    </message>
    <message>
        <source> … %1 more</source>
        <translation> … dalších %1</translation>
    </message>
    <message>
        <source>line %1 × %2</source>
        <translation>řádek %1 × %2</translation>
    </message>
    <message>
        <source>No rule applies to this word.</source>
        <translation>Na toto slovo se nehodí žádné pravidlo.</translation>
    </message>
    <message>
        <source>To the next: %1</source>
        <translation>K dalšímu: %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Připojit</translation>
    </message>
</context>
<context>
    <name>stromar::CLightPanel</name>
    <message>
        <source>Reset light</source>
        <translation>Obnovit světlo</translation>
    </message>
    <message>
        <source>%1 stops</source>
        <translation>%1 stupňů</translation>
    </message>
</context>
<context>
    <name>stromar::CMainWindow</name>
    <message>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Předvolby</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianty</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Jak byl otevřen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historie</translation>
    </message>
    <message>
        <source>Messages of the file</source>
        <translation>Zprávy k souboru</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Zprávy</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Nástroje</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Otevřít &amp;nedávné</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>Zamíchat</translation>
    </message>
    <message>
        <source>The graphics driver has started again</source>
        <translation>Ovladač grafiky se znovu spustil</translation>
    </message>
    <message>
        <source>Stopped; F6 grows the full model</source>
        <translation>Zastaveno; F6 vypěstuje úplný model</translation>
    </message>
    <message>
        <source>No manual</source>
        <translation>Příručka chybí</translation>
    </message>
    <message>
        <source>The pages of the manual are not installed.</source>
        <translation>Stránky příručky nejsou nainstalované.</translation>
    </message>
    <message>
        <source>About Stromar</source>
        <translation>O programu Stromar</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Grows trees by the model of Weber and Penn, “Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Pěstuje stromy podle modelu Webera a Penna, „Creation and Rendering of Realistic Trees“, SIGGRAPH ’95.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Světlo</translation>
    </message>
    <message>
        <source>New &amp;Tree by</source>
        <translation>Nový &amp;strom metodou</translation>
    </message>
    <message>
        <source>The tree is growing; Esc cancels</source>
        <translation>Strom roste; Esc růst zruší</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>%1   %2   %3 leaves   %4 vertices   %5 triangles   %6 ms</source>
        <translation>%1   %2   %3 listů   %4 vrcholů   %5 trojúhelníků   %6 ms</translation>
    </message>
    <message>
        <source>Saved Cameras</source>
        <translation>Uložené kamery</translation>
    </message>
    <message>
        <source>Nothing has grown yet</source>
        <translation>Zatím nic nevyrostlo</translation>
    </message>
    <message>
        <source>No tree was found among these random values; a smaller amount finds some</source>
        <translation>Mezi těmito náhodnými hodnotami se nenašel strom; menší míra nějaký najde</translation>
    </message>
</context>
<context>
    <name>stromar::CMessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Zavřít</translation>
    </message>
</context>
<context>
    <name>stromar::CParamEditor</name>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Jiný strom téhož druhu</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Náhodné semínko</translation>
    </message>
</context>
<context>
    <name>stromar::CParamPanel</name>
    <message>
        <source>Find a parameter</source>
        <translation>Najít parametr</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Načíst…</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Vybrat obrázek</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Nakreslit</translation>
    </message>
    <message>
        <source>A picture that Stromar draws; the words behind its name can be changed</source>
        <translation>Obrázek, který kreslí Stromar; slova za jménem lze měnit</translation>
    </message>
    <message>
        <source>Texture Workshop…</source>
        <translation>Dílna textur…</translation>
    </message>
    <message>
        <source>Choose a mesh</source>
        <translation>Vybrat síť</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Vestavěné</translation>
    </message>
    <message>
        <source>A mesh that comes with Stromar</source>
        <translation>Síť, která je součástí Stromaru</translation>
    </message>
    <message>
        <source>No parameter is called “%1”.</source>
        <translation>Žádný parametr se nejmenuje „%1“.</translation>
    </message>
    <message>
        <source>Where they point</source>
        <translation>Kam směřují</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Hodnoty</translation>
    </message>
    <message>
        <source>Copies, pastes and keeps the values of this tab; a right click on a heading does it with what stands below</source>
        <translation>Kopíruje, vkládá a uchovává hodnoty této karty; pravé kliknutí na nadpis to udělá s tím, co je pod ním</translation>
    </message>
</context>
<context>
    <name>stromar::CParamRow</name>
    <message>
        <source>Without effect: %1</source>
        <translation>Bez účinku: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Výchozí %1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Vložit %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Vložit</translation>
    </message>
    <message>
        <source>&amp;Reset to Default</source>
        <translation>&amp;Výchozí hodnota</translation>
    </message>
    <message>
        <source>Back to the &amp;Saved Value</source>
        <translation>Zpět na &amp;uloženou hodnotu</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Uloženo %1</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopírovat</translation>
    </message>
    <message>
        <source>&amp;Lock against Randomise</source>
        <translation>&amp;Zamknout proti míchání</translation>
    </message>
    <message>
        <source>Copy to &amp;Level</source>
        <translation>Kopírovat do ú&amp;rovně</translation>
    </message>
</context>
<context>
    <name>stromar::CPictureDialog</name>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Průhledné pozadí</translation>
    </message>
    <message>
        <source>Save a Picture</source>
        <translation>Uložit obrázek</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Jeden obrázek</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> snímků</translation>
    </message>
    <message>
        <source>More than one: the tree turns once around, each frame a numbered PNG file</source>
        <translation>Více než jeden: strom se jednou otočí, každý snímek je očíslovaný soubor PNG</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Šíř&amp;ka</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Výška</translation>
    </message>
    <message>
        <source>T&amp;urntable</source>
        <translation>&amp;Otáčení</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Obrázky (*.png *.jpg)</translation>
    </message>
</context>
<context>
    <name>stromar::CPreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Clear the Picture Cache (%1)</source>
        <translation>Vyprázdnit mezipaměť obrázků (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CPresetBrowser</name>
    <message>
        <source>Find a tree</source>
        <translation>Najít strom</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Vše</translation>
    </message>
    <message>
        <source>Stromar&apos;s</source>
        <translation>Ze Stromaru</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Moje vlastní</translation>
    </message>
    <message>
        <source>Folder of presets</source>
        <translation>Složka předvoleb</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Uložit…</translation>
    </message>
    <message>
        <source>Keep the tree in the window as a preset of your own</source>
        <translation>Uchovat strom v okně jako vlastní předvolbu</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Předvolby</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>Autor: %1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Otevřít</translation>
    </message>
    <message>
        <source>&amp;Remove…</source>
        <translation>&amp;Odstranit…</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Odstranit předvolbu</translation>
    </message>
    <message>
        <source>Move “%1” to the waste bin?</source>
        <translation>Přesunout „%1“ do koše?</translation>
    </message>
    <message>
        <source>%1 cannot be removed.</source>
        <translation>%1 nelze odstranit.</translation>
    </message>
    <message>
        <source>No presets yet: Save… keeps the tree in the window.</source>
        <translation>Zatím žádné předvolby: Uložit… uchová strom v okně.</translation>
    </message>
    <message>
        <source>No preset is called “%1”.</source>
        <translation>Žádná předvolba se nejmenuje „%1“.</translation>
    </message>
</context>
<context>
    <name>stromar::CRecordDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Nahrát</translation>
    </message>
    <message>
        <source>Growth, up to the age that is shown</source>
        <translation>Růst až do zobrazeného stáří</translation>
    </message>
    <message>
        <source>Wind, in a loop</source>
        <translation>Vítr ve smyčce</translation>
    </message>
    <message>
        <source>The fall</source>
        <translation>Pád</translation>
    </message>
    <message>
        <source>Numbered pictures (PNG)</source>
        <translation>Číslované obrázky (PNG)</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Co</translation>
    </message>
    <message>
        <source>Wid&amp;th</source>
        <translation>Šíř&amp;ka</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Výška</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Délka</translation>
    </message>
    <message>
        <source>&amp;Frames per second</source>
        <translation>&amp;Snímků za sekundu</translation>
    </message>
    <message>
        <source>&amp;As</source>
        <translation>&amp;Jako</translation>
    </message>
    <message>
        <source>Video (MP4)</source>
        <translation>Video (MP4)</translation>
    </message>
    <message>
        <source>For videos, install ffmpeg.</source>
        <translation>Pro videa nainstalujte ffmpeg.</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>Videa (*.mp4)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Obrázky (*.png)</translation>
    </message>
</context>
<context>
    <name>stromar::CRecorder</name>
    <message>
        <source>Recording</source>
        <translation>Nahrává se</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Recording cancelled; no file was changed</source>
        <translation>Nahrávání zrušeno; žádný soubor se nezměnil</translation>
    </message>
    <message numerus="yes">
        <source>Recording cancelled: %1 of %n frame(s) are saved</source>
        <translation>
            <numerusform>Nahrávání zrušeno: uloženo %1 z %n snímku</numerusform>
            <numerusform>Nahrávání zrušeno: uloženo %1 ze %n snímků</numerusform>
            <numerusform>Nahrávání zrušeno: uloženo %1 z %n snímků</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Uloženo %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s)</source>
        <translation>
            <numerusform>Uložen %n snímek</numerusform>
            <numerusform>Uloženy %n snímky</numerusform>
            <numerusform>Uloženo %n snímků</numerusform>
        </translation>
    </message>
    <message>
        <source>Cannot record</source>
        <translation>Nelze nahrát</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 nelze zapsat.</translation>
    </message>
    <message>
        <source>Making the video</source>
        <translation>Vytváří se video</translation>
    </message>
    <message>
        <source>ffmpeg could not make the video. %1</source>
        <translation>ffmpeg video nevytvořil. %1</translation>
    </message>
</context>
<context>
    <name>stromar::CSavedCameras</name>
    <message>
        <source>None yet: Save Camera keeps one</source>
        <translation>Zatím žádná: uchová ji Uložit kameru</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odstranit</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Uložit kameru</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Jméno pohledu</translation>
    </message>
    <message>
        <source>There is a view called “%1” already. Replace it?</source>
        <translation>Pohled s názvem „%1“ už existuje. Nahradit ho?</translation>
    </message>
</context>
<context>
    <name>stromar::CShortcutsDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Myš a klávesy</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Kolečko</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Blíž a dál</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Kliknutí</translation>
    </message>
    <message>
        <source>Show details of the stem or leaf</source>
        <translation>Ukázat podrobnosti o větvi nebo listu</translation>
    </message>
    <message>
        <source>Scroll; changes an editor only after a click into it</source>
        <translation>Posouvá; hodnotu mění až po kliknutí do ní</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Finer steps of a slider</source>
        <translation>Jemnější kroky posuvníku</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Larger steps of a slider</source>
        <translation>Větší kroky posuvníku</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Dvojklik na název</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Zpět na výchozí hodnotu</translation>
    </message>
    <message>
        <source>Right click on a name</source>
        <translation>Pravé kliknutí na název</translation>
    </message>
    <message>
        <source>Copy, paste, lock</source>
        <translation>Kopírovat, vložit, zamknout</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>V obrázku</translation>
    </message>
    <message>
        <source>In the parameters</source>
        <translation>V parametrech</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klávesy</translation>
    </message>
</context>
<context>
    <name>stromar::CSideBySide</name>
    <message>
        <source>Age %1 %</source>
        <translation>Stáří %1 %</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Jednoduchý</translation>
    </message>
    <message>
        <source>LOD %1</source>
        <translation>LOD %1</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>Trojúhelníky: %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>od %1</translation>
    </message>
</context>
<context>
    <name>stromar::CTextureWorkshop</name>
    <message>
        <source>Texture Workshop</source>
        <translation>Dílna textur</translation>
    </message>
    <message>
        <source>Save Pictures…</source>
        <translation>Uložit obrázky…</translation>
    </message>
    <message>
        <source>Save Pictures</source>
        <translation>Uložit obrázky</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Obrázky (*.png)</translation>
    </message>
    <message>
        <source>Cannot save the pictures</source>
        <translation>Obrázky nelze uložit</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Obrázek</translation>
    </message>
</context>
<context>
    <name>stromar::CThumbnails</name>
    <message>
        <source>There is no OpenGL to draw it.</source>
        <translation>Není tu OpenGL, které by ho nakreslilo.</translation>
    </message>
</context>
<context>
    <name>stromar::CTimeline</name>
    <message>
        <source>A step back</source>
        <translation>O krok zpět</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Přehrát</translation>
    </message>
    <message>
        <source>A step forward</source>
        <translation>O krok vpřed</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Stáří</translation>
    </message>
    <message>
        <source>How old the tree is, or how far it has fallen</source>
        <translation>Jak je strom starý nebo jak daleko spadl</translation>
    </message>
    <message>
        <source>Age %1 %</source>
        <translation>Stáří %1 %</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>How fast it is played</source>
        <translation>Jak rychle se přehrává</translation>
    </message>
    <message>
        <source>Begin anew at the end</source>
        <translation>Na konci začít znovu</translation>
    </message>
    <message>
        <source>Save pictures or a video of it</source>
        <translation>Uložit obrázky nebo video</translation>
    </message>
    <message>
        <source>Fall %1 s</source>
        <translation>Pád %1 s</translation>
    </message>
</context>
<context>
    <name>stromar::CVariants</name>
    <message>
        <source>&amp;Nine Others</source>
        <translation>&amp;Devět jiných</translation>
    </message>
    <message>
        <source>Throw nine other seeds</source>
        <translation>Hodit devět jiných semínek</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Oblíbená semínka</translation>
    </message>
    <message>
        <source>♥ Like</source>
        <translation>♥ Líbí se</translation>
    </message>
    <message>
        <source>Keep the seed of the tree in the window in its file</source>
        <translation>Uchovat semínko stromu v okně v jeho souboru</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Vše</translation>
    </message>
    <message>
        <source>&amp;Randomise</source>
        <translation>&amp;Zamíchat</translation>
    </message>
    <message>
        <source>Move the values by chance; locked ones stay (right click a parameter to lock it)</source>
        <translation>Náhodně pohne hodnotami; zamčené zůstanou (zamyká se pravým kliknutím na parametr)</translation>
    </message>
    <message>
        <source>Random values</source>
        <translation>Náhodné hodnoty</translation>
    </message>
    <message>
        <source>&amp;At most</source>
        <translation>&amp;Nejvýše</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Semínko %1</translation>
    </message>
    <message>
        <source>Ages</source>
        <translation>Stáří</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Age %1</source>
        <translation>Stáří %1</translation>
    </message>
    <message>
        <source>The tree at this part of its life</source>
        <translation>Strom v této části života</translation>
    </message>
    <message>
        <source>Values of</source>
        <translation>Hodnoty</translation>
    </message>
</context>
<context>
    <name>stromar::CViewController</name>
    <message>
        <source>Drag %1</source>
        <translation>Tažení: %1</translation>
    </message>
    <message>
        <source>%1, stem %2 of %3</source>
        <translation>%1, č. %2 z %3</translation>
    </message>
    <message>
        <source>Length %1, radius %2</source>
        <translation>Délka %1, poloměr %2</translation>
    </message>
    <message>
        <source>On %1, stem %2, at %3</source>
        <translation>Na: %1, č. %2, ve vzdálenosti %3</translation>
    </message>
    <message numerus="yes">
        <source>Split into %n path(s)</source>
        <translation>
            <numerusform>Dělí se na %n cestu</numerusform>
            <numerusform>Dělí se na %n cesty</numerusform>
            <numerusform>Dělí se na %n cest</numerusform>
        </translation>
    </message>
    <message>
        <source>Leaf %1 of %2
Length %3, width %4
On %5, stem %6</source>
        <translation>List %1 z %2
Délka %3, šířka %4
Na: %5, č. %6</translation>
    </message>
    <message>
        <source>Height %1, width %2</source>
        <translation>Výška %1, šířka %2</translation>
    </message>
    <message>
        <source>Leaves: %1, %2 triangles</source>
        <translation>Listy: %1, %2 trojúhelníků</translation>
    </message>
    <message>
        <source>Structure %1 ms, mesh %2 ms</source>
        <translation>Struktura %1 ms, síť %2 ms</translation>
    </message>
    <message>
        <source>Writing pictures</source>
        <translation>Zapisují se obrázky</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Cannot save the picture</source>
        <translation>Obrázek nelze uložit</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 nelze zapsat.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Uloženo %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s) of a turntable</source>
        <translation>
            <numerusform>Uložen %n snímek otáčení</numerusform>
            <numerusform>Uloženy %n snímky otáčení</numerusform>
            <numerusform>Uloženo %n snímků otáčení</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Line %1 wrote %n segment(s)</source>
        <translation>
            <numerusform>Řádek %1 napsal %n segment</numerusform>
            <numerusform>Řádek %1 napsal %n segmenty</numerusform>
            <numerusform>Řádek %1 napsal %n segmentů</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This point touches %n branch(es)</source>
        <translation>
            <numerusform>Tento bod ovlivňuje %n větev</numerusform>
            <numerusform>Tento bod ovlivňuje %n větve</numerusform>
            <numerusform>Tento bod ovlivňuje %n větví</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture Behind the Tree</source>
        <translation>Obrázek za stromem</translation>
    </message>
    <message>
        <source>Pictures and HDRI panoramas (*.png *.jpg *.jpeg *.hdr)</source>
        <translation>Obrázky a panoramata HDRI (*.png *.jpg *.jpeg *.hdr)</translation>
    </message>
    <message>
        <source>Cannot show the picture</source>
        <translation>Obrázek nelze zobrazit</translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles</source>
        <translation>%1: %2, %3 trojúhelníků</translation>
    </message>
    <message>
        <source>%1: %2 triangles, from %3 on</source>
        <translation>%1: %2 trojúhelníků, od %3 dál</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Referenční obrázek</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Obrázky (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Height of what the picture shows, from edge to edge (%1)</source>
        <translation>Výška toho, co obrázek ukazuje, od kraje ke kraji (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CViewOverlay</name>
    <message>
        <source>Height %1</source>
        <translation>Výška %1</translation>
    </message>
    <message>
        <source>Before …</source>
        <translation>Předtím…</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Předtím</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Teď</translation>
    </message>
</context>
<context>
    <name>stromar::CViewport</name>
    <message>
        <source>OpenGL 2.1 is needed to show the tree; this display has %1.%2. Files can still be edited and exported.</source>
        <translation>K zobrazení stromu je třeba OpenGL 2.1; tento displej má %1.%2. Soubory lze dál upravovat a exportovat.</translation>
    </message>
    <message>
        <source>There is no OpenGL on this display, so the tree cannot be shown. Install your graphics driver. Files can still be edited and exported.</source>
        <translation>Na tomto displeji není OpenGL, strom tedy nelze ukázat. Nainstalujte ovladač grafiky. Soubory lze dál upravovat a exportovat.</translation>
    </message>
    <message>
        <source>Picture of the tree</source>
        <translation>Obrázek stromu</translation>
    </message>
</context>
<context>
    <name>stromar::CWelcomeCard</name>
    <message>
        <source>Welcome to Stromar.</source>
        <translation>Vítejte ve Stromaru.</translation>
    </message>
    <message>
        <source>Begin with a tree and change it:</source>
        <translation>Začněte stromem a změňte ho:</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>All Presets</source>
        <translation>Všechny předvolby</translation>
    </message>
    <message>
        <source>Open a File…</source>
        <translation>Otevřít soubor…</translation>
    </message>
    <message>
        <source>New Tree by</source>
        <translation>Nový strom podle</translation>
    </message>
</context>
<context>
    <name>stromar::CWindPanel</name>
    <message>
        <source>Breeze</source>
        <translation>Vánek</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vítr</translation>
    </message>
    <message>
        <source>Gale</source>
        <translation>Vichřice</translation>
    </message>
    <message>
        <source>S&amp;way in the wind</source>
        <translation>&amp;Kymácet ve větru</translation>
    </message>
    <message>
        <source>Flexibility: %1</source>
        <translation>Ohebnost: %1</translation>
    </message>
</context>
</TS>
