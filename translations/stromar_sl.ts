<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sl">
<context>
    <name>ClampingBox</name>
    <message>
        <source>The maximum is %1</source>
        <translation>Največ je %1</translation>
    </message>
    <message>
        <source>The minimum is %1</source>
        <translation>Najmanj je %1</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Novo</translation>
    </message>
    <message>
        <source>Start with a plain tree</source>
        <translation>Začni s preprostim drevesom</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Odpri…</translation>
    </message>
    <message>
        <source>Open a .tree file</source>
        <translation>Odpri datoteko .tree</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Shrani</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Shrani drevo</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Shrani &amp;kot…</translation>
    </message>
    <message>
        <source>Save the tree in another file</source>
        <translation>Shrani drevo v drugo datoteko</translation>
    </message>
    <message>
        <source>Save as &amp;Preset…</source>
        <translation>Shrani kot &amp;predlogo…</translation>
    </message>
    <message>
        <source>Keep the tree among your own presets</source>
        <translation>Uvrsti drevo med lastne predloge</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Izvozi…</translation>
    </message>
    <message>
        <source>Write the tree for another program</source>
        <translation>Zapiši drevo za drug program</translation>
    </message>
    <message>
        <source>Save P&amp;icture…</source>
        <translation>Shrani s&amp;liko…</translation>
    </message>
    <message>
        <source>A picture of the tree, or the frames of a turntable</source>
        <translation>Slika drevesa ali posnetki vrtečega se drevesa</translation>
    </message>
    <message>
        <source>Load &amp;Bark Texture…</source>
        <translation>Naloži teksturo &amp;lubja…</translation>
    </message>
    <message>
        <source>Choose the picture on the stems</source>
        <translation>Izberi sliko na deblu in vejah</translation>
    </message>
    <message>
        <source>Load &amp;Leaf Texture…</source>
        <translation>Naloži teksturo lis&amp;ta…</translation>
    </message>
    <message>
        <source>Choose the picture on the leaves</source>
        <translation>Izberi sliko na listih</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Končaj</translation>
    </message>
    <message>
        <source>Leave Stromar</source>
        <translation>Zapusti Stromar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Razveljavi</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Vzemi zadnjo spremembo nazaj</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Uveljavi</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Ponovi spremembo</translation>
    </message>
    <message>
        <source>&amp;Find Parameter</source>
        <translation>&amp;Najdi parameter</translation>
    </message>
    <message>
        <source>Look for a parameter by its name</source>
        <translation>Poišči parameter po imenu</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>N&amp;astavitve…</translation>
    </message>
    <message>
        <source>Theme, language, mouse, units</source>
        <translation>Tema, jezik, miška, enote</translation>
    </message>
    <message>
        <source>&amp;Another Seed</source>
        <translation>&amp;Drugo seme</translation>
    </message>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Drugo drevo iste vrste</translation>
    </message>
    <message>
        <source>&amp;Generate</source>
        <translation>&amp;Ustvari znova</translation>
    </message>
    <message>
        <source>Build the tree again from scratch</source>
        <translation>Zgradi drevo od začetka</translation>
    </message>
    <message>
        <source>&amp;Full Model</source>
        <translation>Polni &amp;model</translation>
    </message>
    <message>
        <source>Show the full model now</source>
        <translation>Pokaži polni model takoj</translation>
    </message>
    <message>
        <source>&amp;Stop Growing</source>
        <translation>U&amp;stavi rast</translation>
    </message>
    <message>
        <source>Give up the tree that is growing, and let go of what is selected</source>
        <translation>Opusti drevo, ki raste, in izbiro</translation>
    </message>
    <message>
        <source>&amp;Recentre</source>
        <translation>&amp;Na sredino</translation>
    </message>
    <message>
        <source>See the whole tree from the front</source>
        <translation>Celo drevo od spredaj</translation>
    </message>
    <message>
        <source>&amp;Frame the Tree</source>
        <translation>Celo &amp;drevo</translation>
    </message>
    <message>
        <source>See the whole tree from where you are</source>
        <translation>Celo drevo od tam, kjer ste</translation>
    </message>
    <message>
        <source>From the Fr&amp;ont</source>
        <translation>Od s&amp;predaj</translation>
    </message>
    <message>
        <source>Look along the Y axis</source>
        <translation>Pogled vzdolž osi Y</translation>
    </message>
    <message>
        <source>Look along the X axis</source>
        <translation>Pogled vzdolž osi X</translation>
    </message>
    <message>
        <source>From A&amp;bove</source>
        <translation>Od z&amp;goraj</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Pogled navzdol</translation>
    </message>
    <message>
        <source>Ort&amp;hographic</source>
        <translation>&amp;Vzporedna projekcija</translation>
    </message>
    <message>
        <source>Without perspective</source>
        <translation>Brez perspektive</translation>
    </message>
    <message>
        <source>Turn &amp;Freely</source>
        <translation>Vrti pr&amp;osto</translation>
    </message>
    <message>
        <source>Roll the tree in all directions instead of keeping it upright</source>
        <translation>Vrti drevo v vse smeri, ne le pokonci</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>Ž&amp;ični</translation>
    </message>
    <message>
        <source>Show the wireframe</source>
        <translation>Pokaži žični model</translation>
    </message>
    <message>
        <source>Show the wireframe on the shaded tree</source>
        <translation>Pokaži žični model na senčenem drevesu</translation>
    </message>
    <message>
        <source>&amp;Bare</source>
        <translation>&amp;Golo</translation>
    </message>
    <message>
        <source>Hide the leaves</source>
        <translation>Skrij liste</translation>
    </message>
    <message>
        <source>&amp;Grid and Person</source>
        <translation>&amp;Mreža in oseba</translation>
    </message>
    <message>
        <source>Show a grid of metres and a person beside the tree</source>
        <translation>Pokaži metrsko mrežo in osebo ob drevesu</translation>
    </message>
    <message>
        <source>&amp;Statistics</source>
        <translation>&amp;Statistika</translation>
    </message>
    <message>
        <source>Show sizes and counts in the picture</source>
        <translation>Pokaži mere in števila v sliki</translation>
    </message>
    <message>
        <source>S&amp;ky</source>
        <translation>&amp;Nebo</translation>
    </message>
    <message>
        <source>Sky and ground behind the tree</source>
        <translation>Nebo in tla za drevesom</translation>
    </message>
    <message>
        <source>&amp;Light Grey</source>
        <translation>Sv&amp;etlo siva</translation>
    </message>
    <message>
        <source>A light, plain backdrop</source>
        <translation>Svetlo enobarvno ozadje</translation>
    </message>
    <message>
        <source>&amp;Dark Grey</source>
        <translation>Te&amp;mno siva</translation>
    </message>
    <message>
        <source>A dark, plain backdrop</source>
        <translation>Temno enobarvno ozadje</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Ponastavi razporeditev</translation>
    </message>
    <message>
        <source>Put all docks back to where they were at first</source>
        <translation>Vrni vse plošče na prvotna mesta</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Priročnik</translation>
    </message>
    <message>
        <source>Read how Stromar works</source>
        <translation>Preberi, kako deluje Stromar</translation>
    </message>
    <message>
        <source>Mouse and &amp;Keys</source>
        <translation>Miška in &amp;tipke</translation>
    </message>
    <message>
        <source>How to move about, and all shortcuts</source>
        <translation>Kako se premikati in vse bližnjice</translation>
    </message>
    <message>
        <source>&amp;About Stromar</source>
        <translation>&amp;O programu Stromar</translation>
    </message>
    <message>
        <source>Version and origin</source>
        <translation>Različica in izvor</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datoteka</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Uredi</translation>
    </message>
    <message>
        <source>&amp;Tree</source>
        <translation>Dr&amp;evo</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Po&amp;gled</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Okno</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Pomoč</translation>
    </message>
    <message>
        <source>&amp;Lit</source>
        <translation>&amp;Osvetljeno</translation>
    </message>
    <message>
        <source>The tree in the light</source>
        <translation>Drevo v svetlobi</translation>
    </message>
    <message>
        <source>&amp;Material Alone</source>
        <translation>Samo &amp;material</translation>
    </message>
    <message>
        <source>The pictures without light</source>
        <translation>Slike brez svetlobe</translation>
    </message>
    <message>
        <source>O&amp;cclusion Alone</source>
        <translation>Samo &amp;zasenčenje</translation>
    </message>
    <message>
        <source>How much of the sky each place sees</source>
        <translation>Koliko neba vidi vsako mesto</translation>
    </message>
    <message>
        <source>&amp;Normals Alone</source>
        <translation>Samo &amp;normale</translation>
    </message>
    <message>
        <source>Where each place faces, as a colour</source>
        <translation>Kam je obrnjeno vsako mesto, kot barva</translation>
    </message>
    <message>
        <source>Wireframe &amp;over the Tree</source>
        <translation>Žice če&amp;z drevo</translation>
    </message>
    <message>
        <source>&amp;Record…</source>
        <translation>&amp;Posnemi…</translation>
    </message>
    <message>
        <source>Pictures or a video of the tree as it grows or sways</source>
        <translation>Slike ali video drevesa, ki raste ali se ziblje</translation>
    </message>
    <message>
        <source>&amp;Play Growth</source>
        <translation>&amp;Predvajaj rast</translation>
    </message>
    <message>
        <source>Let the tree grow from its first day</source>
        <translation>Naj drevo raste od prvega dne</translation>
    </message>
    <message>
        <source>W&amp;ind</source>
        <translation>V&amp;eter</translation>
    </message>
    <message>
        <source>Let the tree sway in the wind</source>
        <translation>Naj se drevo ziblje v vetru</translation>
    </message>
    <message>
        <source>F&amp;ell…</source>
        <translation>Po&amp;deri…</translation>
    </message>
    <message>
        <source>Cut the tree and let it fall; the timeline runs over its fall</source>
        <translation>Podreti drevo; časovnica teče po njegovem padcu</translation>
    </message>
    <message>
        <source>&amp;Picture or Panorama…</source>
        <translation>&amp;Slika ali panorama …</translation>
    </message>
    <message>
        <source>Tint What Is &amp;Edited</source>
        <translation>Obarvaj, kar s&amp;e ureja</translation>
    </message>
    <message>
        <source>Keep the tint of what the value in hand changes; else it only flashes</source>
        <translation>Obarvano ostane, kar spreminja izbrana vrednost; sicer le utripne</translation>
    </message>
    <message>
        <source>A photograph, or an HDRI panorama that lights the tree</source>
        <translation>Fotografija ali panorama HDRI, ki osvetljuje drevo</translation>
    </message>
    <message>
        <source>Level of Detail &amp;0</source>
        <translation>Raven podrobnosti &amp;0</translation>
    </message>
    <message>
        <source>The full model, for near views</source>
        <translation>Polni model, za poglede od blizu</translation>
    </message>
    <message>
        <source>Level of Detail &amp;1</source>
        <translation>Raven podrobnosti &amp;1</translation>
    </message>
    <message>
        <source>The full model as it is seen from some way off</source>
        <translation>Polni model, kot je viden z nekaj razdalje</translation>
    </message>
    <message>
        <source>Level of Detail &amp;2</source>
        <translation>Raven podrobnosti &amp;2</translation>
    </message>
    <message>
        <source>The full model from afar, with cards of whole twigs</source>
        <translation>Polni model od daleč, s karticami celih vejic</translation>
    </message>
    <message>
        <source>Level of Detail &amp;3</source>
        <translation>Raven podrobnosti &amp;3</translation>
    </message>
    <message>
        <source>The coarsest full model, for trees on the horizon</source>
        <translation>Najbolj grob polni model, za drevesa na obzorju</translation>
    </message>
    <message>
        <source>At Its Distance</source>
        <translation>Na njeni razdalji</translation>
    </message>
    <message>
        <source>Move to where a program would begin to show this level of detail</source>
        <translation>Premakni se tja, kjer bi program začel kazati to raven podrobnosti</translation>
    </message>
    <message>
        <source>From the Back</source>
        <translation>Od zadaj</translation>
    </message>
    <message>
        <source>From the Right</source>
        <translation>Z desne</translation>
    </message>
    <message>
        <source>From the Left</source>
        <translation>Z leve</translation>
    </message>
    <message>
        <source>From Below</source>
        <translation>Od spodaj</translation>
    </message>
    <message>
        <source>Look up</source>
        <translation>Pogled navzgor</translation>
    </message>
    <message>
        <source>Save Camera…</source>
        <translation>Shrani pogled…</translation>
    </message>
    <message>
        <source>Keep this view of the tree under a name</source>
        <translation>Ohrani ta pogled na drevo pod imenom</translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation>Merilo</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure</source>
        <translation>Povlecite od ene točke do druge, da izmerite razdaljo</translation>
    </message>
    <message>
        <source>Reference Picture…</source>
        <translation>Referenčna slika…</translation>
    </message>
    <message>
        <source>A picture of a real tree, in its true size, behind the one in the window</source>
        <translation>Slika pravega drevesa v pravi velikosti za drevesom v oknu</translation>
    </message>
    <message>
        <source>Keep as “Before”</source>
        <translation>Ohrani kot »prej«</translation>
    </message>
    <message>
        <source>Keep the tree as it is now, to compare with what you make of it</source>
        <translation>Ohrani drevo, kakršno je zdaj, za primerjavo s tem, kar iz njega naredite</translation>
    </message>
    <message>
        <source>Show “Before”</source>
        <translation>Pokaži »prej«</translation>
    </message>
    <message>
        <source>The tree as it was kept, until this is switched off or a value changes</source>
        <translation>Ohranjeno drevo, dokler to ni izklopljeno ali se ne spremeni vrednost</translation>
    </message>
    <message>
        <source>One Tree</source>
        <translation>Eno drevo</translation>
    </message>
    <message>
        <source>The tree alone</source>
        <translation>Samo drevo</translation>
    </message>
    <message>
        <source>Nine Seeds Side by Side</source>
        <translation>Devet semen drugo ob drugem</translation>
    </message>
    <message>
        <source>The tree among eight others of its kind</source>
        <translation>Drevo med osmimi drugimi svoje vrste</translation>
    </message>
    <message>
        <source>Five Ages Side by Side</source>
        <translation>Pet starosti drugo ob drugem</translation>
    </message>
    <message>
        <source>The tree from its youth to its full age</source>
        <translation>Drevo od mladosti do polne starosti</translation>
    </message>
    <message>
        <source>Four Seasons Side by Side</source>
        <translation>Štirje letni časi drug ob drugem</translation>
    </message>
    <message>
        <source>The tree in winter, spring, summer and autumn</source>
        <translation>Drevo pozimi, spomladi, poleti in jeseni</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Dobrodošli</translation>
    </message>
    <message>
        <source>The ways to begin, as at the first start</source>
        <translation>Načini za začetek, kot ob prvem zagonu</translation>
    </message>
    <message>
        <source>Look along the negative Y axis</source>
        <translation>Pogled v nasprotni smeri osi Y</translation>
    </message>
    <message>
        <source>Look along the negative X axis</source>
        <translation>Pogled v nasprotni smeri osi X</translation>
    </message>
    <message>
        <source>I&amp;mport…</source>
        <translation>U&amp;vozi …</translation>
    </message>
    <message>
        <source>Read a tree of Arbaro, Sapling or tree-gen</source>
        <translation>Preberi drevo programa Arbaro, Sapling ali tree-gen</translation>
    </message>
    <message>
        <source>Simple Model</source>
        <translation>Preprosti model</translation>
    </message>
    <message>
        <source>The model that follows a slider, instead of the full one</source>
        <translation>Model, ki sledi drsniku, namesto polnega</translation>
    </message>
    <message>
        <source>Wipe between “Before” and Now</source>
        <translation>Meja med »prej« in zdaj</translation>
    </message>
    <message>
        <source>Both trees with a line between them, which can be dragged</source>
        <translation>Obe drevesi in med njima črta, ki jo je mogoče vleči</translation>
    </message>
    <message>
        <source>Levels of Detail Side by Side</source>
        <translation>Ravni podrobnosti druga ob drugi</translation>
    </message>
    <message>
        <source>The four levels of detail and the simple model, with their triangles</source>
        <translation>Štiri ravni podrobnosti in preprosti model s številom trikotnikov</translation>
    </message>
    <message>
        <source>Look From</source>
        <translation>Smer pogleda</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Ozadje</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Senčenje</translation>
    </message>
    <message>
        <source>Level of Detail</source>
        <translation>Raven podrobnosti</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Primerjava</translation>
    </message>
    <message>
        <source>Side by Side</source>
        <translation>Drug ob drugem</translation>
    </message>
</context>
<context>
    <name>Counts</name>
    <message>
        <source>1 stem</source>
        <translation>1 veja</translation>
    </message>
    <message>
        <source>%1 stems</source>
        <translation>%1 vej</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Preprosti model</translation>
    </message>
    <message>
        <source>Full model</source>
        <translation>Polni model</translation>
    </message>
    <message>
        <source>Level of detail %1</source>
        <translation>Raven podrobnosti %1</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>Cannot use the values</source>
        <translation>Vrednosti ni mogoče uporabiti</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Prilepi %1</translation>
    </message>
    <message>
        <source>Save Values</source>
        <translation>Shrani vrednosti</translation>
    </message>
    <message>
        <source>Name of these values</source>
        <translation>Ime teh vrednosti</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odstrani</translation>
    </message>
    <message>
        <source>&amp;Copy Values</source>
        <translation>&amp;Kopiraj vrednosti</translation>
    </message>
    <message>
        <source>&amp;Paste Values</source>
        <translation>&amp;Prilepi vrednosti</translation>
    </message>
    <message>
        <source>&amp;Save Values…</source>
        <translation>&amp;Shrani vrednosti…</translation>
    </message>
    <message>
        <source>There is no value for %1 among these lines.</source>
        <translation>Med temi vrsticami ni vrednosti za %1.</translation>
    </message>
    <message>
        <source>There are values called “%1” already. Replace them?</source>
        <translation>Vrednosti z imenom »%1« že obstajajo. Naj se zamenjajo?</translation>
    </message>
</context>
<context>
    <name>stromar</name>
    <message>
        <source>Full model</source>
        <translation>Polni model</translation>
    </message>
    <message>
        <source>Simple model</source>
        <translation>Preprosti model</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Ne</translation>
    </message>
    <message>
        <source>In one file</source>
        <translation>V eni datoteki</translation>
    </message>
    <message>
        <source>A file for each</source>
        <translation>Vsaka v svoji datoteki</translation>
    </message>
    <message>
        <source>As usual in the format</source>
        <translation>Kot je v formatu običajno</translation>
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
        <translation>Znotraj datoteke</translation>
    </message>
    <message>
        <source>Copies beside it</source>
        <translation>Kopije ob njej</translation>
    </message>
    <message>
        <source>Where they are</source>
        <translation>Kjer so</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Which model: the full one, or the simple one of the preview.</source>
        <translation>Kateri model: polni ali preprosti iz predogleda.</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Raven podrobnosti</translation>
    </message>
    <message>
        <source>All levels of detail</source>
        <translation>Vse ravni podrobnosti</translation>
    </message>
    <message>
        <source>All four levels of detail: inside one file, or a file for each, named after it.</source>
        <translation>Vse štiri ravni podrobnosti: znotraj ene datoteke ali vsaka v svoji, poimenovani po njej.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Merilo</translation>
    </message>
    <message>
        <source>The model&apos;s metres are multiplied by this: 100 writes centimetres.</source>
        <translation>Metri modela se množijo s tem številom: 100 zapiše centimetre.</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Navpična os</translation>
    </message>
    <message>
        <source>Which axis points up. &apos;format&apos; takes what programs expect of the format.</source>
        <translation>Katera os kaže navzgor. »format« vzame, kar programi od formata pričakujejo.</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Teksture</translation>
    </message>
    <message>
        <source>Pictures inside the file, as copies beside it, or where they lie now. &apos;format&apos; takes what is usual.</source>
        <translation>Slike znotraj datoteke, kot kopije ob njej ali tam, kjer so zdaj. »format« vzame običajno.</translation>
    </message>
    <message>
        <source>%1 cannot hold levels of detail; choose a file for each</source>
        <translation>%1 ne more hraniti ravni podrobnosti; izberite za vsako svojo datoteko</translation>
    </message>
    <message>
        <source>levels of detail belong to the full model; the simple model has none</source>
        <translation>ravni podrobnosti spadajo k polnemu modelu; preprosti jih nima</translation>
    </message>
    <message>
        <source>in %1 files y is always up</source>
        <translation>v datotekah %1 kaže navzgor vedno y</translation>
    </message>
    <message>
        <source>in %1 files z is always up</source>
        <translation>v datotekah %1 kaže navzgor vedno z</translation>
    </message>
    <message>
        <source>%1 cannot hold pictures; choose copies</source>
        <translation>%1 ne more hraniti slik; izberite kopije</translation>
    </message>
    <message>
        <source>glTF, one file</source>
        <translation>glTF, ena datoteka</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nič</translation>
    </message>
    <message>
        <source>glTF, with its buffer and pictures beside it</source>
        <translation>glTF, podatki in slike ob njem</translation>
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
        <translation>Stanford PLY, binarni</translation>
    </message>
    <message>
        <source>STL, binary</source>
        <translation>STL, binarni</translation>
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
        <translation>Prizor POV-Ray</translation>
    </message>
    <message>
        <source>OpenSceneGraph binary</source>
        <translation>OpenSceneGraph, binarni</translation>
    </message>
    <message>
        <source>OpenSceneGraph text</source>
        <translation>OpenSceneGraph, besedilni</translation>
    </message>
    <message>
        <source>OpenSceneGraph, old text form</source>
        <translation>OpenSceneGraph, stara besedilna oblika</translation>
    </message>
    <message>
        <source>Width and widest place</source>
        <translation>Širina in najširše mesto</translation>
    </message>
    <message>
        <source>Curve above</source>
        <translation>Krivulja zgoraj</translation>
    </message>
    <message>
        <source>Curve below</source>
        <translation>Krivulja spodaj</translation>
    </message>
    <message>
        <source>Bare trunk</source>
        <translation>Golo deblo</translation>
    </message>
    <message>
        <source>Length of the branches</source>
        <translation>Dolžina vej</translation>
    </message>
    <message>
        <source>Stromar: left turns, right zooms, middle moves</source>
        <translation>Stromar: leva vrti, desna približa, srednja premika</translation>
    </message>
    <message>
        <source>Blender: middle button with Shift and Ctrl</source>
        <translation>Blender: srednja tipka s Shift in Ctrl</translation>
    </message>
    <message>
        <source>Maya: all buttons with Alt</source>
        <translation>Maya: vse tipke z Alt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>levo</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>srednjo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>desno</translation>
    </message>
    <message>
        <source>%1 drag</source>
        <translation>Vlečenje z %1 tipko</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Vrtenje</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Premik</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Bliže in dlje</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Kot sistem</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Svetla</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Temna</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metri</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Čevlji</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Light or dark windows.</source>
        <translation>Svetla ali temna okna.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Jezik</translation>
    </message>
    <message>
        <source>The language of menus, parameters and help.</source>
        <translation>Jezik menijev, parametrov in pomoči.</translation>
    </message>
    <message>
        <source>Mouse in the picture</source>
        <translation>Miška v sliki</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom. The wheel always zooms.</source>
        <translation>Katere tipke vrtijo, premikajo in približajo. Kolesce vedno približa.</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Dolžine v</translation>
    </message>
    <message>
        <source>The unit of lengths in the window. Files are always in metres.</source>
        <translation>Enota dolžin v oknu. Datoteke so vedno v metrih.</translation>
    </message>
    <message>
        <source>Full model after</source>
        <translation>Polni model po</translation>
    </message>
    <message>
        <source>How long the hand rests before the full model follows the simple one.</source>
        <translation>Kako dolgo mora roka počivati, preden preprostemu modelu sledi polni.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Niti</translation>
    </message>
    <message>
        <source>How many processors grow the tree; 0 takes all.</source>
        <translation>Koliko procesorjev goji drevo; 0 vzame vse.</translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation>Samodejno shrani vsakih</translation>
    </message>
    <message>
        <source>How often changes are kept aside against a crash; 0 never.</source>
        <translation>Kako pogosto se spremembe hranijo za primer sesutja; 0 nikoli.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>conical</source>
        <translation>stožčasta</translation>
    </message>
    <message>
        <source>spherical</source>
        <translation>krogelna</translation>
    </message>
    <message>
        <source>hemispherical</source>
        <translation>polkrogelna</translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation>valjasta</translation>
    </message>
    <message>
        <source>tapered-cylindrical</source>
        <translation>zožena valjasta</translation>
    </message>
    <message>
        <source>flame</source>
        <translation>plamen</translation>
    </message>
    <message>
        <source>inverse-conical</source>
        <translation>obrnjeni stožec</translation>
    </message>
    <message>
        <source>tend-flame</source>
        <translation>blagi plamen</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>ovojnica</translation>
    </message>
    <message>
        <source>oval</source>
        <translation>ovalen</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>trikotnik</translation>
    </message>
    <message>
        <source>three-lobe-oak</source>
        <translation>trokrpi hrastov</translation>
    </message>
    <message>
        <source>three-lobe-maple</source>
        <translation>trokrpi javorov</translation>
    </message>
    <message>
        <source>five-lobe-maple</source>
        <translation>petkrpi javorov</translation>
    </message>
    <message>
        <source>three-leaflets</source>
        <translation>trije lističi</translation>
    </message>
    <message>
        <source>square</source>
        <translation>kvadrat</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>iglice</translation>
    </message>
    <message>
        <source>card</source>
        <translation>karta</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>obris</translation>
    </message>
    <message>
        <source>off</source>
        <translation>izklopljeno</translation>
    </message>
    <message>
        <source>on</source>
        <translation>vklopljeno</translation>
    </message>
    <message>
        <source>The tree is a bare trunk: Levels of stems is 1.</source>
        <translation>Drevo je golo deblo: število ravni je 1.</translation>
    </message>
    <message>
        <source>It acts on stems of level 2 and deeper, and there are none.</source>
        <translation>Deluje na veje ravni 2 in globlje, teh pa ni.</translation>
    </message>
    <message>
        <source>The trunk has no lobes.</source>
        <translation>Deblo nima krp.</translation>
    </message>
    <message>
        <source>The trunk has no lobes, or they have no depth.</source>
        <translation>Deblo nima krp ali pa te nimajo globine.</translation>
    </message>
    <message>
        <source>The trunk has only one segment, so there is no joint to split at.</source>
        <translation>Deblo ima le en člen, zato se nima kje deliti.</translation>
    </message>
    <message>
        <source>These stems never split.</source>
        <translation>Te veje se nikoli ne delijo.</translation>
    </message>
    <message>
        <source>Nothing in this tree splits.</source>
        <translation>V tem drevesu se nič ne deli.</translation>
    </message>
    <message>
        <source>A card shows what its texture shows: set Form to outline.</source>
        <translation>Karta kaže svojo teksturo: nastavite obliko na obris.</translation>
    </message>
    <message>
        <source>Nothing is pruned: Strength is 0.</source>
        <translation>Nič se ne obrezuje: moč je 0.</translation>
    </message>
    <message>
        <source>Nothing is pruned, and the crown shape is not the envelope.</source>
        <translation>Nič se ne obrezuje in oblika krošnje ni ovojnica.</translation>
    </message>
    <message>
        <source>Crown shape</source>
        <translation>Oblika krošnje</translation>
    </message>
    <message>
        <source>Crown</source>
        <translation>Krošnja</translation>
    </message>
    <message>
        <source>The outline of the crown: how long the branches are from its bottom to its top. &apos;envelope&apos; takes the outline of the pruning tab.</source>
        <translation>Obris krošnje: kako dolge so veje od spodaj do vrha. »ovojnica« vzame obris z zavihka obrezovanja.</translation>
    </message>
    <message>
        <source>The part of the tree&apos;s height, from the ground, that bears no branches.</source>
        <translation>Del višine drevesa od tal, ki ne nosi vej.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Višina</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>The height of the tree.</source>
        <translation>Višina drevesa.</translation>
    </message>
    <message>
        <source>Height variation</source>
        <translation>Odstopanje višine</translation>
    </message>
    <message>
        <source>How much taller or smaller a tree of another seed may be.</source>
        <translation>Koliko višje ali nižje je lahko drevo z drugim semenom.</translation>
    </message>
    <message>
        <source>Z scale</source>
        <translation>Merilo Z</translation>
    </message>
    <message>
        <source>Printed in the paper&apos;s tables but used by none of its formulas. Kept in files, without effect.</source>
        <translation>Je v tabelah članka, a ga nobena njegova formula ne rabi. Ostane v datotekah, brez učinka.</translation>
    </message>
    <message>
        <source>Z scale variation</source>
        <translation>Odstopanje merila Z</translation>
    </message>
    <message>
        <source>Levels of stems</source>
        <translation>Ravni vejitve</translation>
    </message>
    <message>
        <source>1 grows a bare trunk, 2 adds branches, 3 branches on branches. The leaves sit on the last level.</source>
        <translation>1 zraste golo deblo, 2 doda veje, 3 veje na vejah. Listi so na zadnji ravni.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Debelina</translation>
    </message>
    <message>
        <source>The radius of the trunk divided by its length.</source>
        <translation>Polmer debla, deljen z njegovo dolžino.</translation>
    </message>
    <message>
        <source>Thinning</source>
        <translation>Tanjšanje</translation>
    </message>
    <message>
        <source>How much thinner than its parent a shorter branch is. Higher values make finer branches.</source>
        <translation>Koliko tanjša od starša je krajša veja. Višje vrednosti naredijo finejše veje.</translation>
    </message>
    <message>
        <source>No stem is drawn thinner than this, so that fine twigs stay visible.</source>
        <translation>Nič se ne nariše tanjše, da fine vejice ostanejo vidne.</translation>
    </message>
    <message>
        <source>Attraction up</source>
        <translation>Vzravnavanje</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Rast</translation>
    </message>
    <message>
        <source>How strongly branches of level 2 and deeper bend up to the light. Negative values let them hang.</source>
        <translation>Kako močno se veje ravni 2 in globlje upogibajo navzgor k svetlobi. Negativne vrednosti jih pustijo viseti.</translation>
    </message>
    <message>
        <source>Halve splitting</source>
        <translation>Razpolovi delitve</translation>
    </message>
    <message>
        <source>On: a stem that has split, and its clones, split half as often from then on.</source>
        <translation>Vklopljeno: veja, ki se je razdelila, in njeni kloni se odtlej delijo pol manj.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <source>Every seed gives another tree of the same kind. The same seed always grows the same tree.</source>
        <translation>Vsako seme da drugo drevo iste vrste. Isto seme vedno zraste isto drevo.</translation>
    </message>
    <message>
        <source>Radius factor</source>
        <translation>Faktor polmera</translation>
    </message>
    <message>
        <source>Makes the trunk thicker or thinner than Thickness says, and the branches with it.</source>
        <translation>Naredi deblo debelejše ali tanjše, kot pravi debelina, in veje z njim.</translation>
    </message>
    <message>
        <source>Radius factor variation</source>
        <translation>Odstopanje faktorja polmera</translation>
    </message>
    <message>
        <source>How much the radius factor differs from seed to seed.</source>
        <translation>Koliko se faktor polmera razlikuje od semena do semena.</translation>
    </message>
    <message>
        <source>Flare</source>
        <translation>Koreničnik</translation>
    </message>
    <message>
        <source>How much the trunk widens at the ground. 1 makes it twice as thick there.</source>
        <translation>Koliko se deblo razširi pri tleh. 1 ga tam naredi dvakrat debelejše.</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Krpe</translation>
    </message>
    <message>
        <source>The number of bulges around the trunk. Odd numbers look natural, even ones symmetric.</source>
        <translation>Število izboklin okoli debla. Liha števila so videti naravna, soda somerna.</translation>
    </message>
    <message>
        <source>Lobe depth</source>
        <translation>Globina krp</translation>
    </message>
    <message>
        <source>How far the bulges stand out, as a part of the radius.</source>
        <translation>Kako daleč izbokline štrlijo, kot del polmera.</translation>
    </message>
    <message>
        <source>Lobes fade</source>
        <translation>Pojemanje krp</translation>
    </message>
    <message>
        <source>1 lets the lobes end a little above the ground, 0 lets them run up the whole trunk.</source>
        <translation>1 konča krpe malo nad tlemi, 0 jih pelje po vsem deblu.</translation>
    </message>
    <message>
        <source>Splits at the base</source>
        <translation>Delitve pri dnu</translation>
    </message>
    <message>
        <source>Splitting</source>
        <translation>Delitev</translation>
    </message>
    <message>
        <source>So many more trunks grow out of the end of the trunk&apos;s first segment.</source>
        <translation>Toliko dodatnih debel zraste iz konca prvega člena debla.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Število</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Razmestitev</translation>
    </message>
    <message>
        <source>The most branches of this level that one parent can bear.</source>
        <translation>Največ vej te ravni, kolikor jih lahko nosi en starš.</translation>
    </message>
    <message>
        <source>Spread along segments</source>
        <translation>Razpored po členih</translation>
    </message>
    <message>
        <source>1 spaces the branches evenly, 0 gathers them at the lower end of each segment of the parent, as whorls.</source>
        <translation>1 razmesti veje enakomerno, 0 jih zbere na spodnjem koncu vsakega člena starša kot vretenca.</translation>
    </message>
    <message>
        <source>Place variation</source>
        <translation>Odstopanje mesta</translation>
    </message>
    <message>
        <source>How far each branch is moved along its parent, as a part of the spacing.</source>
        <translation>Kako daleč se vsaka veja premakne vzdolž starša, kot del razmika.</translation>
    </message>
    <message>
        <source>Down angle</source>
        <translation>Kot odklona</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Smer</translation>
    </message>
    <message>
        <source>The angle between a branch and its parent. 90 stands off at a right angle.</source>
        <translation>Kot med vejo in njenim staršem. 90 stoji pravokotno.</translation>
    </message>
    <message>
        <source>Down angle variation</source>
        <translation>Odstopanje kota odklona</translation>
    </message>
    <message>
        <source>How much the down angle differs from branch to branch. Negative values are not random: they grade the angle along the parent, more at its base, less at its tip.</source>
        <translation>Koliko se kot odklona razlikuje od veje do veje. Negativne vrednosti niso naključne: kot stopnjujejo vzdolž starša, več pri dnu, manj pri vrhu.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Zasuk</translation>
    </message>
    <message>
        <source>The turn about the parent from one branch to the next. Negative values put the branches on alternate sides.</source>
        <translation>Zasuk okoli starša od ene veje do naslednje. Negativne vrednosti postavijo veje izmenično na obe strani.</translation>
    </message>
    <message>
        <source>Rotation variation</source>
        <translation>Odstopanje zasuka</translation>
    </message>
    <message>
        <source>How much the rotation differs from branch to branch.</source>
        <translation>Koliko se zasuk razlikuje od veje do veje.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dolžina</translation>
    </message>
    <message>
        <source>The length as a part of the parent&apos;s length; for the trunk, of the tree&apos;s height.</source>
        <translation>Dolžina kot del dolžine starša; pri deblu višine drevesa.</translation>
    </message>
    <message>
        <source>Length variation</source>
        <translation>Odstopanje dolžine</translation>
    </message>
    <message>
        <source>How much the length differs from stem to stem.</source>
        <translation>Koliko se dolžina razlikuje od veje do veje.</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Oženje</translation>
    </message>
    <message>
        <source>The form of the stem: 0 a cylinder, 1 a cone, 2 a cylinder with a round end, 3 a chain of spheres.</source>
        <translation>Oblika lesa: 0 valj, 1 stožec, 2 valj z okroglim koncem, 3 niz krogel.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Členi</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krivina</translation>
    </message>
    <message>
        <source>The number of segments a stem consists of. More segments bend and split more finely.</source>
        <translation>Iz koliko členov je veja. Več členov se upogiba in deli finejše.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Upogib</translation>
    </message>
    <message>
        <source>How much the stem bends from base to tip. Positive values bend down, negative ones up.</source>
        <translation>Koliko se veja upogne od dna do vrha. Pozitivne vrednosti upogibajo navzdol, negativne navzgor.</translation>
    </message>
    <message>
        <source>Curve back</source>
        <translation>Povratni upogib</translation>
    </message>
    <message>
        <source>Unless 0, the lower half bends by Curve and the upper half by this: S-shaped stems.</source>
        <translation>Če ni 0, se spodnja polovica upogiba po upogibu, zgornja pa po tej vrednosti: veje v obliki S.</translation>
    </message>
    <message>
        <source>Curve variation</source>
        <translation>Odstopanje upogiba</translation>
    </message>
    <message>
        <source>Random bending, shared out over the segments. Negative values wind the stem into a helix of that angle.</source>
        <translation>Naključno upogibanje, razdeljeno po členih. Negativne vrednosti zvijejo vejo v vijačnico tega kota.</translation>
    </message>
    <message>
        <source>Splits per segment</source>
        <translation>Delitve na člen</translation>
    </message>
    <message>
        <source>How many clones split off at the end of each segment, on average. 1 forks at every one.</source>
        <translation>Koliko klonov se odcepi na koncu vsakega člena, povprečno. 1 se razcepi pri vsakem.</translation>
    </message>
    <message>
        <source>Split angle</source>
        <translation>Kot delitve</translation>
    </message>
    <message>
        <source>How far each part leans away from the vertical after a split. Towards its tip it turns back again.</source>
        <translation>Kako daleč se po delitvi vsak del nagne od navpičnice. Proti vrhu se spet vrne.</translation>
    </message>
    <message>
        <source>Split angle variation</source>
        <translation>Odstopanje kota delitve</translation>
    </message>
    <message>
        <source>How much the split angle differs from fork to fork.</source>
        <translation>Koliko se kot delitve razlikuje od rogovile do rogovile.</translation>
    </message>
    <message>
        <source>The most leaves that a stem of the last level bears. Negative values put them in a fan at its tip.</source>
        <translation>Največ listov, kolikor jih nosi veja zadnje ravni. Negativne vrednosti jih postavijo v pahljačo na vrhu.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Gostota</translation>
    </message>
    <message>
        <source>Fewer but larger leaves below 1, more and smaller ones above: the leaf area stays.</source>
        <translation>Pod 1 manj, a večjih listov, nad 1 več manjših: površina listov ostane.</translation>
    </message>
    <message>
        <source>Turn to the light</source>
        <translation>Obračanje k svetlobi</translation>
    </message>
    <message>
        <source>How far the leaves turn outwards and up to the light.</source>
        <translation>Kako daleč se listi obračajo navzven in navzgor k svetlobi.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Oblika</translation>
    </message>
    <message>
        <source>Blade</source>
        <translation>Ploskev</translation>
    </message>
    <message>
        <source>The kind of leaf: its outline where the form is &apos;outline&apos;. A card shows what its texture shows.</source>
        <translation>Vrsta lista: njegov obris, kjer je podoba »obris«. Karta kaže svojo teksturo.</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Podoba</translation>
    </message>
    <message>
        <source>A card is a rectangle with the leaf texture. An outline is cut to the shape and needs no transparency.</source>
        <translation>Karta je pravokotnik s teksturo lista. Obris je izrezan po obliki in ne potrebuje prosojnosti.</translation>
    </message>
    <message>
        <source>The length of a leaf.</source>
        <translation>Dolžina lista.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Širina</translation>
    </message>
    <message>
        <source>The width of a leaf as a part of its length.</source>
        <translation>Širina lista kot del njegove dolžine.</translation>
    </message>
    <message>
        <source>Stalk</source>
        <translation>Pecelj</translation>
    </message>
    <message>
        <source>The length of the stalk between stem and blade, as a part of the leaf&apos;s length.</source>
        <translation>Dolžina peclja med vejo in ploskvijo kot del dolžine lista.</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Pregib</translation>
    </message>
    <message>
        <source>How far each half of a leaf is folded up along its midrib.</source>
        <translation>Koliko je vsaka polovica lista pregnjena navzgor ob glavni žili.</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Zaobljenost</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Senčenje</translation>
    </message>
    <message>
        <source>Shades the leaves as if they were the surface of one round crown: softer light on dense crowns.</source>
        <translation>Senči liste, kot bi bili površina ene okrogle krošnje: mehkejša svetloba na gostih krošnjah.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Moč</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Ovojnica</translation>
    </message>
    <message>
        <source>0 leaves the branches alone, 1 shortens them until they stay inside the envelope.</source>
        <translation>0 pusti veje pri miru, 1 jih krajša, dokler ne ostanejo v ovojnici.</translation>
    </message>
    <message>
        <source>The radius of the envelope at its widest place, as a part of the tree&apos;s height.</source>
        <translation>Polmer ovojnice na najširšem mestu kot del višine drevesa.</translation>
    </message>
    <message>
        <source>Widest place</source>
        <translation>Najširše mesto</translation>
    </message>
    <message>
        <source>Where the envelope is widest, from 0 at its bottom to 1 at its top.</source>
        <translation>Kje je ovojnica najširša, od 0 spodaj do 1 na vrhu.</translation>
    </message>
    <message>
        <source>The envelope below its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Ovojnica pod najširšim mestom: pod 1 je izbočena, 1 ravna, nad 1 vbočena.</translation>
    </message>
    <message>
        <source>The envelope above its widest place: under 1 it bulges, 1 is straight, above 1 it is hollow.</source>
        <translation>Ovojnica nad najširšim mestom: pod 1 je izbočena, 1 ravna, nad 1 vbočena.</translation>
    </message>
    <message>
        <source>Bark repeats around</source>
        <translation>Ponovitve lubja okoli</translation>
    </message>
    <message>
        <source>Bark</source>
        <translation>Lubje</translation>
    </message>
    <message>
        <source>How often the bark picture goes around the trunk; branches follow. Whole numbers leave no seam.</source>
        <translation>Kolikokrat slika lubja obkroži deblo; veje sledijo. Cela števila ne pustijo šiva.</translation>
    </message>
    <message>
        <source>Bark repeats along</source>
        <translation>Ponovitve lubja vzdolž</translation>
    </message>
    <message>
        <source>Species</source>
        <translation>Vrsta</translation>
    </message>
    <message>
        <source>About</source>
        <translation>O drevesu</translation>
    </message>
    <message>
        <source>The name of the kind of tree.</source>
        <translation>Ime vrste drevesa.</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Avtor</translation>
    </message>
    <message>
        <source>Who made the file.</source>
        <translation>Kdo je naredil datoteko.</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Opis</translation>
    </message>
    <message>
        <source>What the tree is like.</source>
        <translation>Kakšno je drevo.</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Priljubljena semena</translation>
    </message>
    <message>
        <source>Seeds worth finding again, separated by blanks.</source>
        <translation>Semena, ki jih je vredno znova najti, ločena s presledki.</translation>
    </message>
    <message>
        <source>Bark texture</source>
        <translation>Tekstura lubja</translation>
    </message>
    <message>
        <source>Leaf texture</source>
        <translation>Tekstura lista</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Listi</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: see Levels of stems.</source>
        <translation>Drevo nima vej te ravni: glejte Ravni vejitve.</translation>
    </message>
    <message>
        <source>The tree has no stems of this level: a Number of branches is 0.</source>
        <translation>Drevo nima vej te ravni: neko število vej je 0.</translation>
    </message>
    <message>
        <source>This level would place the leaves, and the tree has none.</source>
        <translation>Ta raven bi razmestila liste, drevo pa jih nima.</translation>
    </message>
    <message>
        <source>Leaves grow on branches, and the tree is a bare trunk.</source>
        <translation>Listi rastejo na vejah, drevo pa je golo deblo.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0.</source>
        <translation>Drevo nima listov: njihovo število je 0.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Drevo</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Deblo</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Veje</translation>
    </message>
    <message>
        <source>Pruning</source>
        <translation>Obrezovanje</translation>
    </message>
    <message>
        <source>The picture on the stems; its path starts at the file&apos;s folder. A recipe as bark:furrowed seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Slika na lesu; pot se začne v mapi datoteke. Recept, kot je bark:furrowed seed=3, se nariše. Prazno vzame vgrajeno.</translation>
    </message>
    <message>
        <source>furrowed</source>
        <translation>razbrazdano</translation>
    </message>
    <message>
        <source>plated</source>
        <translation>luskasto</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>gladko</translation>
    </message>
    <message>
        <source>birch</source>
        <translation>breza</translation>
    </message>
    <message>
        <source>willow</source>
        <translation>vrba</translation>
    </message>
    <message>
        <source>cherry</source>
        <translation>češnja</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>palma</translation>
    </message>
    <message>
        <source>Another bark of the same kind.</source>
        <translation>Drugo lubje iste vrste.</translation>
    </message>
    <message>
        <source>Ridges</source>
        <translation>Grebeni</translation>
    </message>
    <message>
        <source>How many ridges or plates stand side by side in the picture.</source>
        <translation>Koliko grebenov ali lusk stoji v sliki drug ob drugem.</translation>
    </message>
    <message>
        <source>Length of ridges</source>
        <translation>Dolžina grebenov</translation>
    </message>
    <message>
        <source>How many times longer than wide they are.</source>
        <translation>Kolikokrat so daljši kot širši.</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Razpoke</translation>
    </message>
    <message>
        <source>How wide the furrows between them are, as a part of a ridge.</source>
        <translation>Kako široke so brazde med njimi, kot del grebena.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Globina</translation>
    </message>
    <message>
        <source>How deep the relief is.</source>
        <translation>Kako globok je relief.</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Zrnatost</translation>
    </message>
    <message>
        <source>How rough the surface is in detail.</source>
        <translation>Kako hrapava je površina od blizu.</translation>
    </message>
    <message>
        <source>Wandering</source>
        <translation>Vijuganje</translation>
    </message>
    <message>
        <source>How crooked ridges and rings run.</source>
        <translation>Kako krivo tečejo grebeni in obroči.</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Obroči</translation>
    </message>
    <message>
        <source>How many bands run around the stem in the picture.</source>
        <translation>Koliko pasov v sliki obkroža deblo.</translation>
    </message>
    <message>
        <source>Spots</source>
        <translation>Pege</translation>
    </message>
    <message>
        <source>How many pores or eyes there are.</source>
        <translation>Koliko je por ali oči.</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Svetla barva</translation>
    </message>
    <message>
        <source>The colour of what stands out.</source>
        <translation>Barva tega, kar štrli.</translation>
    </message>
    <message>
        <source>Dark colour</source>
        <translation>Temna barva</translation>
    </message>
    <message>
        <source>The colour of what lies deep.</source>
        <translation>Barva tega, kar leži globoko.</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Čas dneva</translation>
    </message>
    <message>
        <source>Where the sun stands: low and red in the morning and in the evening.</source>
        <translation>Kje stoji sonce: zjutraj in zvečer nizko in rdeče.</translation>
    </message>
    <message>
        <source>Sun direction</source>
        <translation>Smer sonca</translation>
    </message>
    <message>
        <source>Turns the sun&apos;s way about the tree.</source>
        <translation>Zavrti sončno pot okoli drevesa.</translation>
    </message>
    <message>
        <source>lance</source>
        <translation>suličast</translation>
    </message>
    <message>
        <source>heart</source>
        <translation>srčast</translation>
    </message>
    <message>
        <source>pinnate</source>
        <translation>pernat</translation>
    </message>
    <message>
        <source>palmate</source>
        <translation>dlanast</translation>
    </message>
    <message>
        <source>fan</source>
        <translation>pahljača</translation>
    </message>
    <message>
        <source>Only cards have several planes: set Form to card.</source>
        <translation>Več ravnin imajo le kartice: Obliko nastavite na kartico.</translation>
    </message>
    <message>
        <source>The tree has only one trunk.</source>
        <translation>Drevo ima le eno deblo.</translation>
    </message>
    <message>
        <source>The tree has no leaves, blossoms or fruits.</source>
        <translation>Drevo nima listov, cvetov ne plodov.</translation>
    </message>
    <message>
        <source>The tree has no blossoms: their Number is 0.</source>
        <translation>Drevo nima cvetov: njihovo Število je 0.</translation>
    </message>
    <message>
        <source>The tree has no fruits: their Number is 0.</source>
        <translation>Drevo nima plodov: njihovo Število je 0.</translation>
    </message>
    <message>
        <source>Month</source>
        <translation>Mesec</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Letni čas</translation>
    </message>
    <message>
        <source>The time of the year: 0 is New Year, 4.5 spring, 7 summer, 10 autumn. Leaves, their colour, blossoms and fruits follow.</source>
        <translation>Čas v letu: 0 je novo leto, 4,5 pomlad, 7 poletje, 10 jesen. Sledijo mu listi, njihova barva, cvetovi in plodovi.</translation>
    </message>
    <message>
        <source>Evergreen</source>
        <translation>Zimzeleno</translation>
    </message>
    <message>
        <source>On: the leaves stay, and stay green, through the winter.</source>
        <translation>Vklopljeno: listi ostanejo čez zimo, in to zeleni.</translation>
    </message>
    <message>
        <source>Trunks</source>
        <translation>Debla</translation>
    </message>
    <message>
        <source>Several trunks</source>
        <translation>Več debel</translation>
    </message>
    <message>
        <source>How many trunks rise from one base: shrubs, clumps of bamboo.</source>
        <translation>Koliko debel raste iz enega dna: grmi, šopi bambusa.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Razmik</translation>
    </message>
    <message>
        <source>How far from the middle the outermost trunk stands.</source>
        <translation>Kako daleč od sredine stoji skrajno deblo.</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Nagib</translation>
    </message>
    <message>
        <source>How far the outermost trunk leans outwards; the others less.</source>
        <translation>Koliko se skrajno deblo nagiba navzven; druga manj.</translation>
    </message>
    <message>
        <source>At one place</source>
        <translation>Na enem mestu</translation>
    </message>
    <message>
        <source>How many branches leave their parent at the same height, all around it: 2 are opposite, more a whorl.</source>
        <translation>Koliko vej izrašča na isti višini vse naokoli: 2 sta nasprotni, več jih je vretence.</translation>
    </message>
    <message>
        <source>How many leaves leave a stem at the same place: 1 are alternate, 2 opposite, more a whorl.</source>
        <translation>Koliko listov izrašča na istem mestu: 1 premenjalni, 2 nasprotna, več vretence.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ravnine</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one leaf: 2 or 3 for tufts and twigs of needles.</source>
        <translation>Koliko kartic, zasukanih okoli dolžine, sestavlja en list: 2 ali 3 za šope in vejice iglic.</translation>
    </message>
    <message>
        <source>Blossoms</source>
        <translation>Cvetovi</translation>
    </message>
    <message>
        <source>The most blossoms that a stem of the last level bears. They stand where leaves could.</source>
        <translation>Največ cvetov na steblu zadnje ravni. Stojijo tam, kjer bi lahko bili listi.</translation>
    </message>
    <message>
        <source>The length and width of a blossom, or of the cluster that its picture shows.</source>
        <translation>Dolžina in širina cveta ali socvetja na njegovi sliki.</translation>
    </message>
    <message>
        <source>When the tree is in full blossom; it begins and ends most of a month before and after.</source>
        <translation>Kdaj je drevo v polnem cvetu; začne in konča skoraj mesec prej in pozneje.</translation>
    </message>
    <message>
        <source>Fruits</source>
        <translation>Plodovi</translation>
    </message>
    <message>
        <source>The most fruits that a stem of the last level bears.</source>
        <translation>Največ plodov na steblu zadnje ravni.</translation>
    </message>
    <message>
        <source>The length of a ripe fruit.</source>
        <translation>Dolžina zrelega ploda.</translation>
    </message>
    <message>
        <source>The width of a fruit as a part of its length: small for cones and pods.</source>
        <translation>Širina ploda kot del dolžine: majhna za storže in stroke.</translation>
    </message>
    <message>
        <source>The length of the stalk that a fruit hangs on, as a part of its own length.</source>
        <translation>Dolžina peclja, na katerem visi plod, kot del njegove dolžine.</translation>
    </message>
    <message>
        <source>When the fruits are ripe. They grow in the two months before and fall in the month after.</source>
        <translation>Kdaj so plodovi zreli. Rastejo dva meseca prej in odpadejo mesec pozneje.</translation>
    </message>
    <message>
        <source>The picture on the leaves, transparent outside the blade. A recipe as leaf:oak seed=3 is drawn. Empty takes the built-in one.</source>
        <translation>Slika na listih, zunaj ploskve prozorna. Recept kot leaf:oak seed=3 se nariše. Prazno vzame vgrajeno.</translation>
    </message>
    <message>
        <source>Blossom texture</source>
        <translation>Tekstura cvetov</translation>
    </message>
    <message>
        <source>Blossoms and fruits</source>
        <translation>Cvetovi in plodovi</translation>
    </message>
    <message>
        <source>The picture on the blossoms. Empty draws leaf:blossom.</source>
        <translation>Slika na cvetovih. Prazno nariše leaf:blossom.</translation>
    </message>
    <message>
        <source>Fruit texture</source>
        <translation>Tekstura plodov</translation>
    </message>
    <message>
        <source>The skin of the fruits. Empty draws a red one.</source>
        <translation>Lupina plodov. Prazno nariše rdečo.</translation>
    </message>
    <message>
        <source>Blossoms and fruits grow on branches, and the tree is a bare trunk.</source>
        <translation>Cvetovi in plodovi rastejo na vejah, drevo pa je golo deblo.</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Cvet</translation>
    </message>
    <message>
        <source>beech</source>
        <translation>bukev</translation>
    </message>
    <message>
        <source>oak</source>
        <translation>hrast</translation>
    </message>
    <message>
        <source>aspen</source>
        <translation>trepetlika</translation>
    </message>
    <message>
        <source>lime</source>
        <translation>lipa</translation>
    </message>
    <message>
        <source>apple</source>
        <translation>jablana</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>oljka</translation>
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
        <translation>japonski javor</translation>
    </message>
    <message>
        <source>ash</source>
        <translation>jesen</translation>
    </message>
    <message>
        <source>acacia</source>
        <translation>akacija</translation>
    </message>
    <message>
        <source>frond</source>
        <translation>palmov list</translation>
    </message>
    <message>
        <source>chestnut</source>
        <translation>kostanj</translation>
    </message>
    <message>
        <source>pine</source>
        <translation>bor</translation>
    </message>
    <message>
        <source>spruce</source>
        <translation>smreka</translation>
    </message>
    <message>
        <source>larch</source>
        <translation>macesen</translation>
    </message>
    <message>
        <source>cedar</source>
        <translation>cedra</translation>
    </message>
    <message>
        <source>cypress</source>
        <translation>cipresa</translation>
    </message>
    <message>
        <source>flower</source>
        <translation>cvet</translation>
    </message>
    <message>
        <source>blossom</source>
        <translation>socvetje</translation>
    </message>
    <message>
        <source>Another leaf of the same kind.</source>
        <translation>Drug list iste vrste.</translation>
    </message>
    <message>
        <source>The width of the picture as a part of its length. Give Width of the tree&apos;s leaves the same value.</source>
        <translation>Širina slike kot del dolžine. Širini listov drevesa dajte enako vrednost.</translation>
    </message>
    <message>
        <source>The part of the length that is stalk.</source>
        <translation>Del dolžine, ki je pecelj.</translation>
    </message>
    <message>
        <source>Where a blade is widest, from 0 at its foot to 1 at its tip.</source>
        <translation>Kje je ploskev najširša, od 0 pri dnu do 1 na konici.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Dno</translation>
    </message>
    <message>
        <source>Below 1 the blade begins round, above 1 like a wedge.</source>
        <translation>Pod 1 se ploskev začne okroglo, nad 1 klinasto.</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Konica</translation>
    </message>
    <message>
        <source>Below 1 the blade ends round, above 1 in a drawn-out point.</source>
        <translation>Pod 1 se ploskev konča okroglo, nad 1 v podaljšani konici.</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>Srce</translation>
    </message>
    <message>
        <source>How far the blade reaches back beside its stalk.</source>
        <translation>Kako daleč sega ploskev nazaj ob peclju.</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zobci</translation>
    </message>
    <message>
        <source>How many teeth each half of a blade has.</source>
        <translation>Koliko zobcev ima vsaka polovica ploskve.</translation>
    </message>
    <message>
        <source>Depth of teeth</source>
        <translation>Globina zobcev</translation>
    </message>
    <message>
        <source>How deep they are cut, as a part of the half&apos;s width.</source>
        <translation>Kako globoko so zarezani, kot del širine polovice.</translation>
    </message>
    <message>
        <source>Depth of lobes</source>
        <translation>Globina krp</translation>
    </message>
    <message>
        <source>How deep they are cut. Of leaflets and needles: how wide they are.</source>
        <translation>Kako globoko so zarezane. Pri lističih in iglicah: kako široki so.</translation>
    </message>
    <message>
        <source>Slant</source>
        <translation>Poševnost</translation>
    </message>
    <message>
        <source>How far teeth and lobes lean towards the tip.</source>
        <translation>Koliko se zobci in krpe nagibajo h konici.</translation>
    </message>
    <message>
        <source>Leaflets</source>
        <translation>Lističi</translation>
    </message>
    <message>
        <source>Pairs of leaflets, leaflets of a hand, needles or petals.</source>
        <translation>Pari lističev, lističi dlani, iglice ali venčni listi.</translation>
    </message>
    <message>
        <source>How far lobes, leaflets or needles stand off, in degrees.</source>
        <translation>Koliko štrlijo krpe, lističi ali iglice, v stopinjah.</translation>
    </message>
    <message>
        <source>Veins</source>
        <translation>Žile</translation>
    </message>
    <message>
        <source>How many veins leave the midrib on each side.</source>
        <translation>Koliko žil zapusti glavno žilo na vsaki strani.</translation>
    </message>
    <message>
        <source>Blemishes</source>
        <translation>Madeži</translation>
    </message>
    <message>
        <source>How many spots and worn places there are.</source>
        <translation>Koliko je peg in obrabljenih mest.</translation>
    </message>
    <message>
        <source>Gloss</source>
        <translation>Sijaj</translation>
    </message>
    <message>
        <source>How much the upper side shines.</source>
        <translation>Koliko se sveti zgornja stran.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Barva</translation>
    </message>
    <message>
        <source>The colour in summer.</source>
        <translation>Barva poleti.</translation>
    </message>
    <message>
        <source>Veins&apos; colour</source>
        <translation>Barva žil</translation>
    </message>
    <message>
        <source>The colour of veins and stalks.</source>
        <translation>Barva žil in pecljev.</translation>
    </message>
    <message>
        <source>Autumn colour</source>
        <translation>Jesenska barva</translation>
    </message>
    <message>
        <source>The colour when the green has gone.</source>
        <translation>Barva, ko zelena izgine.</translation>
    </message>
    <message>
        <source>0.5 is the middle of January, 7 the height of summer, 10.5 late autumn.</source>
        <translation>0,5 je sredina januarja, 7 višek poletja, 10,5 pozna jesen.</translation>
    </message>
    <message>
        <source>candle</source>
        <translation>svečka</translation>
    </message>
    <message>
        <source>The trunk has no roots.</source>
        <translation>Deblo nima korenin.</translation>
    </message>
    <message>
        <source>Roots</source>
        <translation>Korenine</translation>
    </message>
    <message>
        <source>The number of ridges that run from the trunk into the ground. High ones are buttresses.</source>
        <translation>Število grebenov, ki tečejo z debla v tla. Visoki so oporne korenine.</translation>
    </message>
    <message>
        <source>Reach of roots</source>
        <translation>Doseg korenin</translation>
    </message>
    <message>
        <source>How far the roots reach out of the trunk on the ground, in radii of the trunk.</source>
        <translation>Kako daleč korenine na tleh segajo iz debla, v polmerih debla.</translation>
    </message>
    <message>
        <source>Height of roots</source>
        <translation>Višina korenin</translation>
    </message>
    <message>
        <source>Where the roots leave the trunk, as a part of its length.</source>
        <translation>Kje korenine zapustijo deblo, kot del njegove dolžine.</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>Pokončnost</translation>
    </message>
    <message>
        <source>1 sets blossoms upright like candles, -1 lets them hang like catkins, 0 lets them stand like leaves.</source>
        <translation>1 postavi cvetove pokonci kot sveče, -1 jih pusti viseti kot mačice, 0 stati kot liste.</translation>
    </message>
    <message>
        <source>How many cards, turned about their length, make one blossom: 2 or 3 for candles and catkins.</source>
        <translation>Koliko kartic, zasukanih okoli dolžine, sestavlja en cvet: 2 ali 3 za sveče in mačice.</translation>
    </message>
    <message>
        <source>Min radius</source>
        <translation>Najm. polmer</translation>
    </message>
    <message>
        <source>Weber and Penn</source>
        <translation>Weber in Penn</translation>
    </message>
    <message>
        <source>Botanical values by level: trunk, branches, twigs. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</source>
        <translation>Botanične vrednosti po ravneh: deblo, veje, vejice. Creation and Rendering of Realistic Trees, SIGGRAPH 1995.</translation>
    </message>
    <message>
        <source>Memory for a tree</source>
        <translation>Pomnilnik za drevo</translation>
    </message>
    <message>
        <source>The most that a tree may take while it is made; 0 is half of what is free.</source>
        <translation>Koliko sme drevo največ zasesti med nastajanjem; 0 je polovica prostega.</translation>
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
        <translation>Nič se ne upogiba: moč tropizma je 0.</translation>
    </message>
    <message>
        <source>Every turn of the grammar has a number.</source>
        <translation>Vsak zasuk v gramatiki ima svoje število.</translation>
    </message>
    <message>
        <source>It places the leaves of stems: their Number is 0. Leaves that the grammar writes stand where it says.</source>
        <translation>Postavlja liste na vejah: njihovo Število je 0. Listi, ki jih piše gramatika, stojijo, kjer določi.</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Pravila</translation>
    </message>
    <message>
        <source>The rules that the tree grows by: values, an axiom, and productions that rewrite every module of the word at once.</source>
        <translation>Pravila, po katerih raste drevo: vrednosti, aksiom in produkcije, ki hkrati prepišejo vse module besede.</translation>
    </message>
    <message>
        <source>Derivations</source>
        <translation>Izpeljave</translation>
    </message>
    <message>
        <source>How often the word is rewritten.</source>
        <translation>Kolikokrat se beseda prepiše.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Enota dolžine</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Želva</translation>
    </message>
    <message>
        <source>How long F(1) is.</source>
        <translation>Kako dolg je F(1).</translation>
    </message>
    <message>
        <source>Unit of width</source>
        <translation>Enota širine</translation>
    </message>
    <message>
        <source>How thick wood of the width !(1) is: a diameter.</source>
        <translation>Kako debel je les širine !(1): premer.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kot</translation>
    </message>
    <message>
        <source>How far + - &amp; ^ \ / turn where they have no number.</source>
        <translation>Za koliko zasukajo + - &amp; ^ \ / brez števila.</translation>
    </message>
    <message>
        <source>Tropism</source>
        <translation>Tropizem</translation>
    </message>
    <message>
        <source>How far every F bends towards the tropism&apos;s direction when it stands square to it, in radians.</source>
        <translation>Za koliko se vsak F upogne proti smeri tropizma, če stoji pravokotno nanjo, v radianih.</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>Smer X</translation>
    </message>
    <message>
        <source>Where stems bend to: gravity points down, light up, wind aside.</source>
        <translation>Kam se veje upogibajo: teža navzdol, svetloba navzgor, veter vstran.</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>Smer Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>Smer Z</translation>
    </message>
    <message>
        <source>Where stems bend to: -1 is down.</source>
        <translation>Kam se veje upogibajo: -1 je navzdol.</translation>
    </message>
    <message>
        <source>How many leaves a stem without branches bears, besides those that the grammar writes as ~L.</source>
        <translation>Koliko listov nosi veja brez odganjkov, poleg tistih, ki jih gramatika piše kot ~L.</translation>
    </message>
    <message>
        <source>The angle between these leaves and their stem.</source>
        <translation>Kot med temi listi in njihovo vejo.</translation>
    </message>
    <message>
        <source>The turn about the stem from one of these leaves to the next.</source>
        <translation>Zasuk okoli veje od enega od teh listov do naslednjega.</translation>
    </message>
    <message>
        <source>The tree has no leaves: their Number is 0, and the grammar writes no ~L.</source>
        <translation>Drevo nima listov: njihovo Število je 0 in gramatika ne piše ~L.</translation>
    </message>
    <message>
        <source>L-system</source>
        <translation>L-sistem</translation>
    </message>
    <message>
        <source>A grammar rewrites a word, and a turtle draws it. The Algorithmic Beauty of Plants, chapters 1 and 2.</source>
        <translation>Gramatika prepisuje besedo, želva jo nariše. The Algorithmic Beauty of Plants, poglavji 1 in 2.</translation>
    </message>
    <message>
        <source>L-systems (*.l *.lsys)</source>
        <translation>L-sistemi (*.l *.lsys)</translation>
    </message>
    <message>
        <source>Strands</source>
        <translation>Prameni</translation>
    </message>
    <message>
        <source>Turns aside (Gravelius order)</source>
        <translation>Odcepi (red po Graveliusu)</translation>
    </message>
    <message>
        <source>Splits below (Weibull order)</source>
        <translation>Cepitve pod njo (red po Weibullu)</translation>
    </message>
    <message>
        <source>height, m</source>
        <translation>višina, m</translation>
    </message>
    <message>
        <source>from the root, m</source>
        <translation>od korenine, m</translation>
    </message>
    <message>
        <source>thickness, cm</source>
        <translation>debelina, cm</translation>
    </message>
    <message>
        <source>turns aside</source>
        <translation>odcepi</translation>
    </message>
    <message>
        <source>splits below</source>
        <translation>cepitve pod njo</translation>
    </message>
    <message>
        <source>order</source>
        <translation>red</translation>
    </message>
    <message>
        <source>height</source>
        <translation>višina</translation>
    </message>
    <message>
        <source>rootLength</source>
        <translation>dolžina od korenine</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>debelina</translation>
    </message>
    <message>
        <source>What the curve runs over: the number of turns aside from the trunk (order), or the height in metres, the length from the root in metres, the thickness in centimetres of the branch that splits, at its base.</source>
        <translation>Po čem teče krivulja: število odcepov od debla (red) ali višina v metrih, dolžina od korenine v metrih ali debelina v centimetrih na začetku veje, ki se cepi.</translation>
    </message>
    <message>
        <source>It places the leaves of twigs: their Number is 0.</source>
        <translation>Razporeja liste vejic: njihovo število je 0.</translation>
    </message>
    <message>
        <source>How many strands the trunk has, S: each of them ends in a twig of its own, so a tree has as many twigs and 2S - 1 branches.</source>
        <translation>Koliko pramenov ima deblo, S: vsak se konča v svoji vejici, zato ima drevo prav toliko vejic in 2S - 1 vej.</translation>
    </message>
    <message>
        <source>Height of the trunk</source>
        <translation>Višina debla</translation>
    </message>
    <message>
        <source>How long the trunk is below its first split.</source>
        <translation>Kako dolgo je deblo pod prvo cepitvijo.</translation>
    </message>
    <message>
        <source>Inherited length</source>
        <translation>Podedovana dolžina</translation>
    </message>
    <message>
        <source>The length that the first branches inherit, L: every split hands a part of it on.</source>
        <translation>Dolžina, ki jo podedujejo prve veje, L: vsaka cepitev preda del naprej.</translation>
    </message>
    <message>
        <source>Thickness of a strand</source>
        <translation>Debelina pramena</translation>
    </message>
    <message>
        <source>How thick a branch of one strand is. One of S strands has the diameter d = this times the root of S, so that the wood above a split has the area of that below.</source>
        <translation>Kako debela je veja z enim pramenom. Veja s S prameni ima premer d = ta vrednost krat koren iz S, zato ima les nad cepitvijo enak presek kot pod njo.</translation>
    </message>
    <message>
        <source>Strands of the leader</source>
        <translation>Prameni vodilne veje</translation>
    </message>
    <message>
        <source>Shares</source>
        <translation>Deleži</translation>
    </message>
    <message>
        <source>The part of the strands that goes on in the leader at a split, k_s: it gets S1 = 1 + (k_s (S - 2) rounded up), the side branch the rest. 0.5 splits evenly, 1 makes a single axis with twigs.</source>
        <translation>Del pramenov, ki gre ob cepitvi naprej v vodilno vejo, k_s: dobi S1 = 1 + (k_s (S - 2) zaokroženo navzgor), stranska veja ostanek. 0,5 cepi enakomerno, 1 da eno samo os z vejicami.</translation>
    </message>
    <message>
        <source>Turn of the leader</source>
        <translation>Zasuk vodilne veje</translation>
    </message>
    <message>
        <source>Gravicentralism, k_c: the leader turns aside by this times the split angle times the root of S2 / S, the side branch by the rest. 0 goes straight on, as many trunks do.</source>
        <translation>Gravicentralizem, k_c: vodilna veja se odkloni za to vrednost krat kot cepitve krat koren iz S2 / S, stranska veja za ostanek. 0 gre naravnost naprej kot mnoga debla.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Koti</translation>
    </message>
    <message>
        <source>The angle between leader and side branch at a split, α.</source>
        <translation>Kot med vodilno in stransko vejo ob cepitvi, α.</translation>
    </message>
    <message>
        <source>Turn of the plane</source>
        <translation>Zasuk ravnine</translation>
    </message>
    <message>
        <source>How far the plane of a split is turned about the branch against the one before: 90 and 137.5 wind about it, 0 and 180 lie flat.</source>
        <translation>Za koliko je ravnina cepitve zasukana okoli veje glede na prejšnjo: 90 in 137,5 se vijeta okoli nje, 0 in 180 ležita v ravnini.</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>Povešanje</translation>
    </message>
    <message>
        <source>Gravimorphism: how far every branch turns towards the ground after a split, until it hangs.</source>
        <translation>Gravimorfizem: za koliko se vsaka veja po cepitvi obrne proti tlom, dokler ne visi.</translation>
    </message>
    <message>
        <source>Min length ratio</source>
        <translation>Najmanjše razmerje dolžin</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Dolžine</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at least this part, k_m.</source>
        <translation>Veja podeduje dolžino tiste pod njo krat koren iz svojega deleža pramenov, a najmanj ta del, k_m.</translation>
    </message>
    <message>
        <source>Max length ratio</source>
        <translation>Največje razmerje dolžin</translation>
    </message>
    <message>
        <source>A branch inherits the length of the one below times the root of its part of the strands, but at most this part, k_M.</source>
        <translation>Veja podeduje dolžino tiste pod njo krat koren iz svojega deleža pramenov, a največ ta del, k_M.</translation>
    </message>
    <message>
        <source>Drawn length</source>
        <translation>Narisana dolžina</translation>
    </message>
    <message>
        <source>How much of the inherited length the branches above a split are drawn with, k_l; what they hand on stays the same.</source>
        <translation>Kolikšen del podedovane dolžine se pri vejah nad cepitvijo nariše, k_l; kar predajo naprej, ostane isto.</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Odstopanje</translation>
    </message>
    <message>
        <source>How far angles stray from the curves, by the seed: 0 gives every tree the same form.</source>
        <translation>Kako daleč koti glede na seme odstopajo od krivulj: 0 da vsakemu drevesu isto obliko.</translation>
    </message>
    <message>
        <source>Factors by depth</source>
        <translation>Faktorji po globini</translation>
    </message>
    <message>
        <source>A factor of this value over the depth: how many splits lie below.</source>
        <translation>Faktor te vrednosti po globini: koliko cepitev leži pod vejo.</translation>
    </message>
    <message>
        <source>What curves run over</source>
        <translation>Po čem tečejo krivulje</translation>
    </message>
    <message>
        <source>How many leaves a twig of one strand bears.</source>
        <translation>Koliko listov nosi vejica z enim pramenom.</translation>
    </message>
    <message>
        <source>The angle between the leaves and their twig.</source>
        <translation>Kot med listi in njihovo vejico.</translation>
    </message>
    <message>
        <source>The turn about the twig from one leaf to the next.</source>
        <translation>Zasuk okoli vejice od enega lista do naslednjega.</translation>
    </message>
    <message>
        <source>Strand model</source>
        <translation>Model pramenov</translation>
    </message>
    <message>
        <source>A trunk of strands that split again and again until each is a twig: drawn curves say how. Holton 1994.</source>
        <translation>Deblo iz pramenov, ki se vedno znova cepijo, dokler ni vsak vejica: kako, povedo narisane krivulje. Holton 1994.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brez</translation>
    </message>
    <message>
        <source>Attributes for a shader</source>
        <translation>Atributi za senčilnik</translation>
    </message>
    <message>
        <source>CryEngine vertex colours</source>
        <translation>Barve oglišč CryEngine</translation>
    </message>
    <message>
        <source>Unity Tree Creator colours</source>
        <translation>Barve Unity Tree Creator</translation>
    </message>
    <message>
        <source>Bones with clips</source>
        <translation>Kosti s posnetki</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Veter</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Kosti</translation>
    </message>
    <message>
        <source>How many of the thickest stems get a bone of their own; the others follow theirs. Only with bones.</source>
        <translation>Koliko najdebelejših vej dobi svojo kost; druge jim sledijo. Samo s kostmi.</translation>
    </message>
    <message>
        <source>%1 cannot hold what moves in the wind; choose glTF</source>
        <translation>%1 ne more hraniti gibanja v vetru; izberite glTF</translation>
    </message>
    <message>
        <source>1 is a strong gale, 22 m/s; beyond it is a storm.</source>
        <translation>1 je močan vihar, 22 m/s; nad tem je orkan.</translation>
    </message>
    <message>
        <source>Where it blows to; the arrow in the picture can be dragged too.</source>
        <translation>Kam piha; vlečete lahko tudi puščico na sliki.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Sunki</translation>
    </message>
    <message>
        <source>How much of the strength comes and goes.</source>
        <translation>Kolikšen del jakosti prihaja in odhaja.</translation>
    </message>
    <message>
        <source>Flexibility</source>
        <translation>Prožnost</translation>
    </message>
    <message>
        <source>How far the wood bends in the wind: 0 is stiff, 2 bends twice as far. The tree in still air stays as it is.</source>
        <translation>Kako močno se les upogne v vetru: 0 je tog, 2 se upogne dvakrat bolj. Drevo v mirnem zraku ostane, kakršno je.</translation>
    </message>
    <message>
        <source>Unreal Pivot Painter 2 pictures</source>
        <translation>Slike za Pivot Painter 2 (Unreal)</translation>
    </message>
    <message>
        <source>What lets the tree sway in another program: vertex attributes and a table for a shader, vertex colours as an engine reads them (COLOR_0 then tints the tree where they are not read), pictures of pivots for Unreal, or bones with clips of wind and growth.</source>
        <translation>Kaj drevo zaziblje v drugem programu: atributi oglišč in tabela za senčilnik, barve oglišč, kot jih bere pogon (COLOR_0 drevo obarva tam, kjer jih ne bere), slike vrtišč za Unreal ali kosti s posnetki vetra in rasti.</translation>
    </message>
    <message>
        <source>stem</source>
        <translation>veja</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>vodoravno</translation>
    </message>
    <message>
        <source>Nothing attracts the branches: Attraction up is 0.</source>
        <translation>Vej nič ne vzravnava: Vzravnavanje je 0.</translation>
    </message>
    <message>
        <source>Attraction axis</source>
        <translation>Os vzravnavanja</translation>
    </message>
    <message>
        <source>What attraction turns a branch about. &apos;stem&apos;, as the paper prints it: its own axis, so that one that lies on its side stays. &apos;horizontal&apos;: all hang, or reach up, alike.</source>
        <translation>Okrog česa vzravnavanje obrača vejo. »veja«, kot je natisnjeno v članku: okrog lastne osi, zato tista, ki leži na boku, ostane. »vodoravno«: vse visijo ali se vzpenjajo enako.</translation>
    </message>
    <message>
        <source>Sun strength</source>
        <translation>Moč sonca</translation>
    </message>
    <message>
        <source>0 is an overcast day without shadows, 1 a clear one.</source>
        <translation>0 je oblačen dan brez senc, 1 jasen.</translation>
    </message>
    <message>
        <source>The colour of its light: low is warm and red, high is cold and blue.</source>
        <translation>Barva njegove svetlobe: nizka je topla in rdeča, visoka hladna in modra.</translation>
    </message>
    <message>
        <source>Sky strength</source>
        <translation>Moč neba</translation>
    </message>
    <message>
        <source>How bright the sky is: what lights the shadows.</source>
        <translation>Kako svetlo je nebo: kar osvetljuje sence.</translation>
    </message>
    <message>
        <source>The colour of the sky: low is warm, high is blue.</source>
        <translation>Barva neba: nizka je topla, visoka modra.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Osvetlitev</translation>
    </message>
    <message>
        <source>Makes the whole picture brighter or darker: each stop doubles the light.</source>
        <translation>Celo sliko posvetli ali potemni: vsaka zaslonka svetlobo podvoji.</translation>
    </message>
    <message>
        <source>Colour variation</source>
        <translation>Razlike v barvi</translation>
    </message>
    <message>
        <source>How much leaves differ in hue and lightness, in the window and in its pictures. 0: all are alike.</source>
        <translation>Kako se listi razlikujejo po odtenku in svetlosti, v oknu in na njegovih slikah. 0: vsi so enaki.</translation>
    </message>
    <message>
        <source>Remeshed in voxels</source>
        <translation>Nova mreža iz vokslov</translation>
    </message>
    <message>
        <source>One solid</source>
        <translation>Eno telo</translation>
    </message>
    <message>
        <source>For printing: all wood as one closed surface, without leaves. Of up to 5,000 stems.</source>
        <translation>Za tiskanje: ves les kot ena zaprta ploskev, brez listov. Največ 5000 poganjkov.</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>Velikost voksla</translation>
    </message>
    <message>
        <source>The edge of the cubes that a solid is made of, in metres of the tree. Thinner wood becomes as thick.</source>
        <translation>Rob kock, iz katerih je telo, v metrih drevesa. Tanjši les postane tako debel.</translation>
    </message>
    <message>
        <source>one solid has no levels of detail and does not move in the wind</source>
        <translation>eno telo nima ravni podrobnosti in se ne giblje v vetru</translation>
    </message>
    <message>
        <source>How often the bark picture would repeat from the trunk&apos;s base to its tip if it stayed as thick. Thinner wood shows it smaller, undistorted.</source>
        <translation>Kako pogosto bi se slika lubja ponovila od dna debla do vrha, če bi to ostalo enako debelo. Tanjši les jo kaže manjšo, nepopačeno.</translation>
    </message>
    <message>
        <source>The picture on branches, which have a material of their own then. The trunk shows it where it is as thin as they are. Empty: as the trunk.</source>
        <translation>Slika na vejah, ki imajo potem svoj material. Deblo jo kaže, kjer je tako tanko kot one. Prazno: kot deblo.</translation>
    </message>
    <message>
        <source>curved</source>
        <translation>ukrivljen</translation>
    </message>
    <message>
        <source>cupped</source>
        <translation>skledast</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>valovit</translation>
    </message>
    <message>
        <source>rolled</source>
        <translation>zvit</translation>
    </message>
    <message>
        <source>The leaf has a mesh of its own.</source>
        <translation>List ima svojo mrežo.</translation>
    </message>
    <message>
        <source>The mesh keeps its proportions.</source>
        <translation>Mreža obdrži svoja razmerja.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mreža</translation>
    </message>
    <message>
        <source>A mesh in place of a card: mesh:curved and the like, or a file (.obj, .glb) whose foot is the origin; its path starts at the file&apos;s folder. The leaf texture lies on it by its texture coordinates.</source>
        <translation>Mreža namesto ploskve: mesh:curved in podobne ali datoteka (.obj, .glb), katere vznožje je izhodišče; pot se začne v mapi datoteke. Tekstura lista leži na njej po njenih koordinatah teksture.</translation>
    </message>
    <message>
        <source>Leaf texture 2</source>
        <translation>Tekstura lista 2</translation>
    </message>
    <message>
        <source>Leaf texture 3</source>
        <translation>Tekstura lista 3</translation>
    </message>
    <message>
        <source>Leaf texture 4</source>
        <translation>Tekstura lista 4</translation>
    </message>
    <message>
        <source>Mesh 2</source>
        <translation>Mreža 2</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Vrste</translation>
    </message>
    <message>
        <source>Mesh 3</source>
        <translation>Mreža 3</translation>
    </message>
    <message>
        <source>Mesh 4</source>
        <translation>Mreža 4</translation>
    </message>
    <message>
        <source>Share 2</source>
        <translation>Delež 2</translation>
    </message>
    <message>
        <source>Share 3</source>
        <translation>Delež 3</translation>
    </message>
    <message>
        <source>Share 4</source>
        <translation>Delež 4</translation>
    </message>
    <message>
        <source>The picture on leaves of this kind, which have a material of their own then. Empty: as the first kind.</source>
        <translation>Slika na listih te vrste, ki imajo potem svoj material. Prazno: kot prva vrsta.</translation>
    </message>
    <message>
        <source>The mesh of leaves of this kind. Empty: as the first kind.</source>
        <translation>Mreža listov te vrste. Prazno: kot prva vrsta.</translation>
    </message>
    <message>
        <source>The part of the leaves that is of this kind, with a texture or a mesh of its own.</source>
        <translation>Del listov, ki je te vrste, s svojo teksturo ali mrežo.</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>vgrajena</translation>
    </message>
    <message>
        <source>Bark of branches 1</source>
        <translation>Lubje vej 1</translation>
    </message>
    <message>
        <source>as the trunk</source>
        <translation>kot deblo</translation>
    </message>
    <message>
        <source>Bark of branches 2</source>
        <translation>Lubje vej 2</translation>
    </message>
    <message>
        <source>The picture on branches of branches, which have a material of their own then. Thin branches show it too. Empty: as branches 1.</source>
        <translation>Slika na vejah vej, ki imajo potem svoj material. Kažejo jo tudi tanke veje. Prazno: kot veje 1.</translation>
    </message>
    <message>
        <source>as branches 1</source>
        <translation>kot veje 1</translation>
    </message>
    <message>
        <source>Bark of branches 3</source>
        <translation>Lubje vej 3</translation>
    </message>
    <message>
        <source>The picture on branches 3 and deeper ones, which have a material of their own then. Thin branches 2 show it too. Empty: as branches 2.</source>
        <translation>Slika na vejah 3 in globljih, ki imajo potem svoj material. Kažejo jo tudi tanke veje 2. Prazno: kot veje 2.</translation>
    </message>
    <message>
        <source>as branches 2</source>
        <translation>kot veje 2</translation>
    </message>
    <message>
        <source>as the first kind</source>
        <translation>kot prva vrsta</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brez</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Odmik površine</translation>
    </message>
    <message>
        <source>The relief of the bark as triangles, in cells of so many metres: 0.02 for a trunk seen from near; 0: none. Only level of detail 0 gets it.</source>
        <translation>Relief lubja kot trikotniki, v celicah po toliko metrov: 0,02 za deblo od blizu; 0: brez. Dobi ga le raven podrobnosti 0.</translation>
    </message>
    <message>
        <source>Strength of displacement</source>
        <translation>Moč odmika</translation>
    </message>
    <message>
        <source>How deep displaced bark is: 1 is what the picture of its normals shows. Seen from near it may be more.</source>
        <translation>Kako globoko je odmaknjeno lubje: 1 je toliko, kot kaže slika njegovih normal. Od blizu ga je lahko več.</translation>
    </message>
    <message>
        <source>only the full model&apos;s level of detail 0 has displaced bark</source>
        <translation>odmaknjeno lubje ima le raven podrobnosti 0 polnega modela</translation>
    </message>
    <message>
        <source>Sun and shade</source>
        <translation>Sonce in senca</translation>
    </message>
    <message>
        <source>How much leaves that grow in the shade of the crown differ from those in the sun: at 1 they are 1.6 times as long and wide, and darker in the window and its pictures.</source>
        <translation>Koliko se listi, ki rastejo v senci krošnje, razlikujejo od tistih na soncu: pri 1 so 1,6-krat daljši in širši ter v oknu in na njegovih slikah temnejši.</translation>
    </message>
    <message>
        <source>Dome</source>
        <translation>Izbočenost</translation>
    </message>
    <message>
        <source>How far the middle of a cluster of blossoms stands out: 0 is a flat card, at 1 its edge lies half its width lower.</source>
        <translation>Kako daleč štrli sredina socvetja: 0 je ploska karta, pri 1 je njen rob za pol širine nižje.</translation>
    </message>
    <message>
        <source>How many lobes a half, or a hand-shaped leaf, has. Of blossoms: how many flowers. Of spruce twigs: how many pairs of side twigs.</source>
        <translation>Koliko krp ima polovica ali dlanast list. Pri socvetjih: koliko cvetov. Pri smrekovih vejicah: koliko parov stranskih vejic.</translation>
    </message>
    <message>
        <source>random</source>
        <translation>naključje</translation>
    </message>
    <message>
        <source>autumn winter spring date</source>
        <translation>jesen zima pomlad datum</translation>
    </message>
    <message>
        <source>stiff sway</source>
        <translation>trdota nihanje</translation>
    </message>
    <message>
        <source>root collar buttress base</source>
        <translation>koreninski vrat oporniki podnožje</translation>
    </message>
    <message>
        <source>size</source>
        <translation>velikost</translation>
    </message>
    <message>
        <source>hue tint random</source>
        <translation>odtenek barva naključje</translation>
    </message>
    <message>
        <source>gravity droop weeping</source>
        <translation>težnost povešanje jokajoča</translation>
    </message>
    <message>
        <source>crown base height clear</source>
        <translation>višina krošnje čisto deblo</translation>
    </message>
    <message>
        <source>order recursion generations</source>
        <translation>red rekurzija generacije</translation>
    </message>
    <message>
        <source>girth radius diameter width</source>
        <translation>obseg polmer premer širina</translation>
    </message>
    <message>
        <source>gravity droop weeping hang</source>
        <translation>težnost povešanje jokajoča visenje</translation>
    </message>
    <message>
        <source>shrub clump multi-stem</source>
        <translation>grm šop več debel</translation>
    </message>
    <message>
        <source>count density</source>
        <translation>število gostota</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>naklon</translation>
    </message>
    <message>
        <source>twist spiral phyllotaxis</source>
        <translation>zasuk spirala filotaksija</translation>
    </message>
    <message>
        <source>bend arch</source>
        <translation>upogib lok</translation>
    </message>
    <message>
        <source>fork clone</source>
        <translation>rogovila klon</translation>
    </message>
    <message>
        <source>foliage count density</source>
        <translation>listje število gostota</translation>
    </message>
    <message>
        <source>envelope crop shape</source>
        <translation>ovojnica obrez oblika</translation>
    </message>
    <message>
        <source>As an attribute</source>
        <translation>Kot atribut</translation>
    </message>
    <message>
        <source>In the vertex colours</source>
        <translation>V barvah oglišč</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Zastrtost okolice</translation>
    </message>
    <message>
        <source>How much of the sky vertices see, in glTF files: as an attribute _OCCLUSION for shaders, or multiplied into the vertex colours (COLOR_0), which darkens the crown in programs that compute this light themselves.</source>
        <translation>Koliko neba vidijo oglišča, v datotekah glTF: kot atribut _OCCLUSION za senčilnike ali pomnoženo v barve oglišč (COLOR_0), kar zatemni krošnjo v programih, ki to svetlobo računajo sami.</translation>
    </message>
    <message>
        <source>%1 cannot hold vertex colours; choose glTF</source>
        <translation>%1 ne more vsebovati barv oglišč; izberite glTF</translation>
    </message>
    <message>
        <source>the colours of this wind hold the occlusion already</source>
        <translation>barve tega vetra že vsebujejo zastrtost</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Osvetljeno</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Hrapavost</translation>
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
        <translation>Uvozite datoteko LOD0, druge pa v urejevalniku mreže pod Level Of Detail; sliki vrtišč gresta v funkcijo materiala PivotPainter2FoliageShader.</translation>
    </message>
    <message>
        <source>Unity</source>
        <translation>Unity</translation>
    </message>
    <message>
        <source>With the package glTFast; put the four objects under one with an LOD Group; the mask maps beside the file belong into the HDRP material.</source>
        <translation>S paketom glTFast; štiri objekte dajte pod enega z LOD Group; maske ob datoteki sodijo v material HDRP.</translation>
    </message>
    <message>
        <source>Godot</source>
        <translation>Godot</translation>
    </message>
    <message>
        <source>Give each of the four meshes a visibility range.</source>
        <translation>Vsaki od štirih mrež določite območje vidnosti.</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>The attribute _OCCLUSION can be mixed into the material.</source>
        <translation>Atribut _OCCLUSION je mogoče primešati materialu.</translation>
    </message>
    <message>
        <source>three.js</source>
        <translation>three.js</translation>
    </message>
    <message>
        <source>Add the four scenes to one THREE.LOD.</source>
        <translation>Štiri prizore dodajte v en THREE.LOD.</translation>
    </message>
    <message>
        <source>OpenGL: green is up</source>
        <translation>OpenGL: zelena kaže navzgor</translation>
    </message>
    <message>
        <source>DirectX: green is down</source>
        <translation>DirectX: zelena kaže navzdol</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metal</source>
        <translation>Zasenčenost, hrapavost, kovina</translation>
    </message>
    <message>
        <source>Unity&apos;s mask map</source>
        <translation>Maska za Unity</translation>
    </message>
    <message>
        <source>Pixels that a picture may be wide or high: larger ones are halved until they are no larger; 0: as they are. PNG pictures only.</source>
        <translation>Kolikor pikslov sme biti slika široka ali visoka: večje se razpolavljajo, dokler niso dovolj majhne; 0: kakršne so. Samo slike PNG.</translation>
    </message>
    <message>
        <source>Normal maps</source>
        <translation>Mape normal</translation>
    </message>
    <message>
        <source>Which way the green of normal maps points: up, as OpenGL, Blender, Unity and Godot have it, or down, as DirectX and Unreal.</source>
        <translation>Kam kaže zelena v mapah normal: navzgor, kot jo imajo OpenGL, Blender, Unity in Godot, ali navzdol, kot DirectX in Unreal.</translation>
    </message>
    <message>
        <source>Packed maps</source>
        <translation>Združene mape</translation>
    </message>
    <message>
        <source>One picture for several maps: occlusion, roughness and metal in red, green and blue, or Unity&apos;s mask map beside the file (metal, occlusion, detail, smoothness in alpha).</source>
        <translation>Ena slika za več map: zasenčenost, hrapavost in kovina v rdeči, zeleni in modri, ali maska za Unity ob datoteki (kovina, zasenčenost, podrobnosti, gladkost v kanalu alfa).</translation>
    </message>
    <message>
        <source>Whether leaves have triangles of their own for their back, for programs that do not draw what is seen from behind.</source>
        <translation>Ali imajo listi svoje trikotnike tudi za hrbtno stran, za programe, ki ne rišejo tega, kar je vidno od zadaj.</translation>
    </message>
    <message>
        <source>%1 shows leaves from both sides by itself</source>
        <translation>%1 sam kaže liste z obeh strani</translation>
    </message>
    <message>
        <source>pictures that stay where they are cannot be changed; choose copies</source>
        <translation>slik, ki ostanejo, kjer so, ni mogoče spremeniti; izberite kopije</translation>
    </message>
    <message>
        <source>Of the full model: 0 is the finest, 1 to 3 have about 50, 12 and 4 % of its triangles.</source>
        <translation>Pri polnem modelu: 0 je najfinejša, 1 do 3 imajo približno 50, 12 in 4 % njegovih trikotnikov.</translation>
    </message>
    <message>
        <source>Babylon.js shows one level of detail at a time, Blender and Godot all four on top of each other, others the finest alone: choose a file for each</source>
        <translation>Babylon.js kaže eno stopnjo podrobnosti naenkrat, Blender in Godot vse štiri drugo čez drugo, drugi samo najfinejšo: izberite datoteko za vsako</translation>
    </message>
    <message>
        <source>No: single faces</source>
        <translation>Ne: enojne ploskve</translation>
    </message>
    <message>
        <source>Yes: faces for both sides</source>
        <translation>Da: ploskve za obe strani</translation>
    </message>
    <message>
        <source>Max texture size</source>
        <translation>Največja velikost teksture</translation>
    </message>
    <message>
        <source>Two-sided leaves</source>
        <translation>Dvostranski listi</translation>
    </message>
    <message>
        <source>Picture cache</source>
        <translation>Predpomnilnik slik</translation>
    </message>
    <message>
        <source>%1 holds colours and pivots of the wind, neither attributes nor bones; choose glTF</source>
        <translation>%1 hrani barve in vrtišča za veter, ne pa atributov ali kosti; izberite glTF</translation>
    </message>
    <message>
        <source>%1 files have their pictures inside</source>
        <translation>datoteke %1 imajo slike v sebi</translation>
    </message>
    <message>
        <source>FBX, binary, centimetres</source>
        <translation>FBX, dvojiški, centimetri</translation>
    </message>
    <message>
        <source>USD, text</source>
        <translation>USD, besedilo</translation>
    </message>
    <message>
        <source>USD, a package with its pictures</source>
        <translation>USD, paket s slikami</translation>
    </message>
    <message>
        <source>Comes through (diffuse transmission)</source>
        <translation>Prehaja (difuzna prepustnost)</translation>
    </message>
    <message>
        <source>As a list of capsules beside the file</source>
        <translation>Kot seznam kapsul ob datoteki</translation>
    </message>
    <message>
        <source>As Unreal looks for it: UCX_…</source>
        <translation>Kot jih išče Unreal: UCX_…</translation>
    </message>
    <message>
        <source>As Godot looks for it: …-colonly</source>
        <translation>Kot jih išče Godot: …-colonly</translation>
    </message>
    <message>
        <source>Light through leaves</source>
        <translation>Svetloba skozi liste</translation>
    </message>
    <message>
        <source>Of glTF files: leaves with the light behind them are bright (KHR_materials_diffuse_transmission), in programs that know it; others show them as without it.</source>
        <translation>V datotekah glTF: listi proti svetlobi so svetli (KHR_materials_diffuse_transmission) v programih, ki to poznajo; drugi jih pokažejo kot brez tega.</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Trki</translation>
    </message>
    <message>
        <source>What things bump into: a capsule for each thick stem, as a list beside the file (JSON), or also as meshes with the names that an engine looks for.</source>
        <translation>V kar se stvari zaletijo: kapsula za vsako debelo vejo, kot seznam ob datoteki (JSON) ali tudi kot mreže z imeni, ki jih pogon išče.</translation>
    </message>
    <message>
        <source>%1 does not know light through leaves; choose glTF</source>
        <translation>%1 ne pozna svetlobe skozi liste; izberite glTF</translation>
    </message>
    <message>
        <source>%1 has no objects whose names an engine looks for; choose glTF or FBX</source>
        <translation>%1 nima predmetov, katerih imena bi pogon iskal; izberite glTF ali FBX</translation>
    </message>
    <message>
        <source>collision belongs to one level of detail; choose a file for each</source>
        <translation>trki sodijo k eni ravni podrobnosti; izberite datoteko za vsako</translation>
    </message>
    <message>
        <source>one solid is its own collision</source>
        <translation>eno telo je samo svoj trk</translation>
    </message>
    <message>
        <source>Arbaro, XML</source>
        <translation>Arbaro, XML</translation>
    </message>
    <message>
        <source>Sapling Tree Gen of Blender, presets</source>
        <translation>Sapling Tree Gen za Blender, prednastavitve</translation>
    </message>
    <message>
        <source>tree-gen of Blender, presets</source>
        <translation>tree-gen za Blender, prednastavitve</translation>
    </message>
    <message>
        <source>The most that cached textures and thumbnails may take on the disk. The oldest beyond it are removed.</source>
        <translation>Koliko največ smejo slike in sličice v predpomnilniku zavzeti na disku. Najstarejše nad tem se odstranijo.</translation>
    </message>
    <message>
        <source>displacement needs the heights of the bark: a recipe, or beside its picture %1</source>
        <translation>premik potrebuje višine lubja: recept ali ob njegovi sliki %1</translation>
    </message>
    <message>
        <source>cannot write %1: there is no folder %2</source>
        <translation>ni mogoče zapisati %1: mape %2 ni</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to export</source>
        <translation>drevo je prazno, ničesar ni za izvoz</translation>
    </message>
    <message>
        <source>one solid does not move in the wind</source>
        <translation>eno telo se v vetru ne premika</translation>
    </message>
    <message>
        <source>there is no choice &apos;%1&apos;</source>
        <translation>izbire »%1« ni</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is one of %2, not &apos;%3&apos;</source>
        <translation>»%1« je eno od %2, ne »%3«</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number without decimals</source>
        <translation>»%1«: »%2« ni celo število</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>»%1«: »%2« ni število</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is between %2 and %3, not %4</source>
        <translation>»%1« je med %2 in %3, ne %4</translation>
    </message>
    <message>
        <source>the name of the model file has no ending; it says the format: %1</source>
        <translation>ime datoteke modela nima končnice; ta pove obliko: %1</translation>
    </message>
    <message>
        <source>cannot write &apos;%1&apos;</source>
        <translation>»%1« ni mogoče zapisati</translation>
    </message>
    <message>
        <source>this is no XML: %1</source>
        <translation>to ni XML: %1</translation>
    </message>
    <message>
        <source>there is no &lt;arbaro&gt; with a &lt;species&gt;</source>
        <translation>manjka &lt;arbaro&gt; z elementom &lt;species&gt;</translation>
    </message>
    <message>
        <source>a &lt;param&gt; has a name and a value</source>
        <translation>&lt;param&gt; mora imeti name in value</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known and left out</source>
        <translation>»%1« ni znano in je izpuščeno</translation>
    </message>
    <message>
        <source>&apos;%1&apos; wants a number, not &apos;%2&apos;; it is left out</source>
        <translation>»%1« mora biti število, ne »%2«; izpuščeno je</translation>
    </message>
    <message>
        <source>%1 is %2: %3 is out of its range</source>
        <translation>%1 je %2: %3 je zunaj obsega</translation>
    </message>
    <message>
        <source>these are no values of a tree that is known here</source>
        <translation>to niso vrednosti drevesa, ki bi bilo tu znano</translation>
    </message>
    <message>
        <source>%1: a file of more than 1 MB is no preset of a tree</source>
        <translation>%1: datoteka, večja od 1 MB, ni prednastavitev drevesa</translation>
    </message>
    <message>
        <source>a dictionary {…} with the values of a tree is wanted here</source>
        <translation>tu mora biti slovar {…} z vrednostmi drevesa</translation>
    </message>
    <message>
        <source>nothing but comments may follow the values</source>
        <translation>za vrednostmi smejo slediti le komentarji</translation>
    </message>
    <message>
        <source>&apos;=&apos; is wanted behind the name</source>
        <translation>za imenom mora biti »=«</translation>
    </message>
    <message>
        <source>this text is not closed</source>
        <translation>to besedilo ni zaključeno</translation>
    </message>
    <message>
        <source>a value is wanted here</source>
        <translation>tu mora biti vrednost</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value: only numbers, texts, True, False, None and lists are read</source>
        <translation>»%1« ni vrednost: berejo se le števila, besedila, True, False, None in seznami</translation>
    </message>
    <message>
        <source>&apos;%1&apos; or &apos;%2&apos; is wanted here</source>
        <translation>tu mora biti »%1« ali »%2«</translation>
    </message>
    <message>
        <source>lists are nested too deep</source>
        <translation>seznami so preveč vgnezdeni</translation>
    </message>
    <message>
        <source>this list is too long</source>
        <translation>ta seznam je predolg</translation>
    </message>
    <message>
        <source>dictionaries are nested too deep</source>
        <translation>slovarji so preveč vgnezdeni</translation>
    </message>
    <message>
        <source>a name in quotes is wanted here</source>
        <translation>tu mora biti ime v narekovajih</translation>
    </message>
    <message>
        <source>&apos;:&apos; is wanted here</source>
        <translation>tu mora biti »:«</translation>
    </message>
    <message>
        <source>is too large: a leaf may have at most %1 vertices</source>
        <translation>je prevelika: list ima lahko največ %1 oglišč</translation>
    </message>
    <message>
        <source>is neither .obj nor .glb</source>
        <translation>ni niti .obj niti .glb</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ni mogoče prebrati: %1</translation>
    </message>
    <message>
        <source>is no .glb with a mesh, or too large for a leaf</source>
        <translation>ni .glb z mrežo ali pa je za list prevelika</translation>
    </message>
    <message>
        <source>is no mesh that can be read: %1</source>
        <translation>ni mreža, ki bi jo bilo mogoče prebrati: %1</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>nima trikotnikov</translation>
    </message>
    <message>
        <source>displacement in cells of %1 m would make more than %2 million triangles; choose larger cells</source>
        <translation>premik v celicah po %1 m bi naredil več kot %2 milijona trikotnikov; izberite večje celice</translation>
    </message>
    <message>
        <source>there is no %1; there are %2</source>
        <translation>%1 ni; so pa %2</translation>
    </message>
    <message>
        <source>has no length or no width</source>
        <translation>nima dolžine ali širine</translation>
    </message>
    <message>
        <source>a solid of %1 million voxels is too large; voxels of %2 m would do</source>
        <translation>telo iz %1 milijona vokslov je preveliko; zadoščali bi voksli %2 m</translation>
    </message>
    <message>
        <source>the tree has %1 stems; a solid is made of %2 at most (fewer Levels or Branches)</source>
        <translation>drevo ima %1 vej; telo nastane iz največ %2 (manj ravni ali vej)</translation>
    </message>
    <message>
        <source>the tree is empty, there is nothing to make a solid of</source>
        <translation>drevo je prazno, telesa ni iz česa narediti</translation>
    </message>
    <message>
        <source>point %1 is empty</source>
        <translation>točka %1 je prazna</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) is not x:y</source>
        <translation>točka %1 (»%2«) ni x:y</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has a y that is no number</source>
        <translation>točka %1 (»%2«) ima y, ki ni število</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) has an x that is no number</source>
        <translation>točka %1 (»%2«) ima x, ki ni število</translation>
    </message>
    <message>
        <source>point %1 (&apos;%2&apos;) must lie to the right of the point before it</source>
        <translation>točka %1 (»%2«) mora ležati desno od prejšnje</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>krivulja ima največ %1 točk</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 nima vrednosti</translation>
    </message>
    <message>
        <source>%1 is not a number: &apos;%2&apos;</source>
        <translation>%1 ni število: »%2«</translation>
    </message>
    <message>
        <source>%1 has no choice &apos;%2&apos;</source>
        <translation>%1 nima izbire »%2«</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 mora biti celo število, ne %2</translation>
    </message>
    <message>
        <source>%1 must be from %2 to %3, not %4; taken as %5</source>
        <translation>%1 mora biti od %2 do %3, ne %4; vzeto kot %5</translation>
    </message>
    <message>
        <source>%1: the %2 of point %3 must be from %4 to %5, not %6; taken as the nearest</source>
        <translation>%1: %2 točke %3 mora biti od %4 do %5, ne %6; vzeto najbližje</translation>
    </message>
    <message>
        <source>%1 must not hold a line of three quotes: it would end the text in a file</source>
        <translation>%1 ne sme imeti vrstice treh narekovajev: zaključila bi besedilo v datoteki</translation>
    </message>
    <message>
        <source>known: %1</source>
        <translation>znane: %1</translation>
    </message>
    <message>
        <source>this is a binary tree of the program Kraut, which uses the same file ending; it cannot be read here</source>
        <translation>to je dvojiško drevo programa Kraut, ki uporablja isto končnico; tu ga ni mogoče prebrati</translation>
    </message>
    <message>
        <source>this is UTF-16 text; save it as UTF-8</source>
        <translation>to je besedilo v UTF-16; shranite ga v UTF-8</translation>
    </message>
    <message>
        <source>this is not a text file of parameters</source>
        <translation>to ni besedilna datoteka s parametri</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>datoteka je prazna</translation>
    </message>
    <message>
        <source>this version cannot grow trees by the method &apos;%1&apos;</source>
        <translation>ta različica ne zna gojiti dreves po metodi »%1«</translation>
    </message>
    <message>
        <source>no line %1; read as format %2</source>
        <translation>ni vrstice %1; brano kot oblika %2</translation>
    </message>
    <message>
        <source>a file with the method &apos;%1&apos; says %2</source>
        <translation>datoteka z metodo »%1« navede %2</translation>
    </message>
    <message>
        <source>the text is not closed: a line of three quotes is missing</source>
        <translation>besedilo ni zaključeno: manjka vrstica treh narekovajev</translation>
    </message>
    <message>
        <source>this character is not UTF-8</source>
        <translation>ta znak ni UTF-8</translation>
    </message>
    <message>
        <source>this line is not &apos;Key = Value&apos;</source>
        <translation>ta vrstica ni »Ključ = Vrednost«</translation>
    </message>
    <message>
        <source>the quote is not closed</source>
        <translation>narekovaj ni zaprt</translation>
    </message>
    <message>
        <source>nothing but a comment may follow the closing quote</source>
        <translation>za zaključnim narekovajem sme slediti le komentar</translation>
    </message>
    <message>
        <source>there is no key in front of &apos;=&apos;</source>
        <translation>pred »=« ni ključa</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos; is kept</source>
        <translation>neznani ključ »%1« ostane</translation>
    </message>
    <message>
        <source>Format must be a whole number from 1, not &apos;%1&apos;</source>
        <translation>Format mora biti celo število od 1, ne »%1«</translation>
    </message>
    <message>
        <source>the file has format %1, but this version reads only up to %2; a newer Stromar is needed</source>
        <translation>datoteka ima obliko %1, ta različica pa bere le do %2; potreben je novejši Stromar</translation>
    </message>
    <message>
        <source>a second value for %1; the first is in line %2</source>
        <translation>druga vrednost za %1; prva je v vrstici %2</translation>
    </message>
    <message>
        <source>this is a folder, not a .tree file</source>
        <translation>to je mapa, ne datoteka .tree</translation>
    </message>
    <message>
        <source>a backdrop is a picture, .png or .jpg, or a panorama, .hdr: not %1</source>
        <translation>ozadje je slika .png ali .jpg ali panorama .hdr: ne %1</translation>
    </message>
    <message>
        <source>cannot read the backdrop %1</source>
        <translation>ozadja %1 ni mogoče prebrati</translation>
    </message>
    <message>
        <source>this grammar makes %1 modules in %2 derivations; at most %3 are allowed</source>
        <translation>ta slovnica naredi %1 modulov v %2 izpeljavah; dovoljenih je največ %3</translation>
    </message>
    <message>
        <source>the grammar draws nothing: its word has no F with a length after %1 derivations</source>
        <translation>slovnica ne nariše ničesar: njena beseda po %1 izpeljavah nima F z dolžino</translation>
    </message>
    <message>
        <source>this expression is nested too deeply</source>
        <translation>ta izraz je preveč vgnezden</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not defined here</source>
        <translation>»%1« tu ni določeno</translation>
    </message>
    <message>
        <source>there is no function &apos;%1&apos;</source>
        <translation>funkcije »%1« ni</translation>
    </message>
    <message>
        <source>%1() takes %2 number, not %3</source>
        <translation>%1() vzame %2 število, ne %3</translation>
    </message>
    <message>
        <source>%1() takes %2 numbers, not %3</source>
        <translation>%1() vzame števil: %2, ne %3</translation>
    </message>
    <message>
        <source>this is no finite number</source>
        <translation>to ni končno število</translation>
    </message>
    <message>
        <source>this comment has no end</source>
        <translation>ta komentar nima konca</translation>
    </message>
    <message>
        <source>expected &apos;%1&apos;</source>
        <translation>pričakovano »%1«</translation>
    </message>
    <message>
        <source>this bracket is not closed</source>
        <translation>ta oklepaj ni zaprt</translation>
    </message>
    <message>
        <source>a number is missing here</source>
        <translation>tu manjka število</translation>
    </message>
    <message>
        <source>this is no number</source>
        <translation>to ni število</translation>
    </message>
    <message>
        <source>the bracket of this call is not closed</source>
        <translation>oklepaj tega klica ni zaprt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>»%1« ni število</translation>
    </message>
    <message>
        <source>the axiom is missing: axiom: …</source>
        <translation>manjka aksiom: axiom: …</translation>
    </message>
    <message>
        <source>only #define and #ignore are known</source>
        <translation>znana sta le #define in #ignore</translation>
    </message>
    <message>
        <source>the number of derivations is the value Derivations, not a line of the grammar</source>
        <translation>število izpeljav je vrednost Derivations, ne vrstica slovnice</translation>
    </message>
    <message>
        <source>there is an axiom already</source>
        <translation>aksiom že obstaja</translation>
    </message>
    <message>
        <source>the axiom is empty</source>
        <translation>aksiom je prazen</translation>
    </message>
    <message>
        <source>#define needs a name</source>
        <translation>#define potrebuje ime</translation>
    </message>
    <message>
        <source>nothing may follow the value</source>
        <translation>vrednosti ne sme nič slediti</translation>
    </message>
    <message>
        <source>a value that is defined cannot depend on chance</source>
        <translation>določena vrednost ne more biti odvisna od naključja</translation>
    </message>
    <message>
        <source>polygons { . } are not supported; use ~L for a leaf</source>
        <translation>mnogokotniki { . } niso podprti; za list uporabite ~L</translation>
    </message>
    <message>
        <source>after ~ stands L (leaf), B (blossom) or K (fruit)</source>
        <translation>za ~ stoji L (list), B (cvet) ali K (plod)</translation>
    </message>
    <message>
        <source>a letter is missing here</source>
        <translation>tu manjka črka</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no letter of a word</source>
        <translation>»%1« ni črka besede</translation>
    </message>
    <message>
        <source>the bracket of this module&apos;s numbers is not closed</source>
        <translation>oklepaj števil tega modula ni zaprt</translation>
    </message>
    <message>
        <source>there is no [ for this ]</source>
        <translation>za ta ] ni [</translation>
    </message>
    <message>
        <source>there is no ] for this [</source>
        <translation>za ta [ ni ]</translation>
    </message>
    <message>
        <source>here stands the name of a parameter</source>
        <translation>tu mora biti ime parametra</translation>
    </message>
    <message>
        <source>expected &apos;)&apos; after the parameters</source>
        <translation>za parametri pričakovan »)«</translation>
    </message>
    <message>
        <source>a production rewrites one module: A(x) : condition -&gt; successor</source>
        <translation>produkcija prepiše en modul: A(x) : pogoj -&gt; naslednik</translation>
    </message>
    <message>
        <source>a production has at most 32 parameters</source>
        <translation>produkcija ima največ 32 parametrov</translation>
    </message>
    <message>
        <source>brackets in a context are not supported</source>
        <translation>oklepaji v kontekstu niso podprti</translation>
    </message>
    <message>
        <source>expected &apos;-&gt;&apos;</source>
        <translation>pričakovano »-&gt;«</translation>
    </message>
    <message>
        <source>this production never matches: no word has %1 with %2 numbers</source>
        <translation>ta produkcija se nikoli ne uporabi: nobena beseda nima %1 s številom števil %2</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 modules</source>
        <translation>beseda te slovnice bi imela več kot %1 modulov</translation>
    </message>
    <message>
        <source>the word of this grammar would have more than %1 numbers</source>
        <translation>beseda te slovnice bi imela več kot %1 števil</translation>
    </message>
    <message>
        <source>a number of %1 is not finite when %2 is rewritten</source>
        <translation>število modula %1 ni končno pri prepisu %2</translation>
    </message>
    <message>
        <source>error</source>
        <translation>napaka</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>opozorilo</translation>
    </message>
    <message>
        <source>cannot write %1</source>
        <translation>ni mogoče zapisati %1</translation>
    </message>
    <message>
        <source>cannot write %1: the file on the disk is incomplete</source>
        <translation>ni mogoče zapisati %1: datoteka na disku ni popolna</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>ni mogoče prebrati %1</translation>
    </message>
    <message>
        <source>, did you mean &apos;%1&apos;?</source>
        <translation>, ste mislili »%1«?</translation>
    </message>
    <message>
        <source>as they are</source>
        <translation>kakor so</translation>
    </message>
    <message>
        <source>a row of trees has a file for each level of detail; choose that or one level</source>
        <translation>vrsta dreves ima za vsako raven podrobnosti svojo datoteko; izberite to ali eno raven</translation>
    </message>
    <message>
        <source>a row of trees stands still; choose one tree or no wind</source>
        <translation>vrsta dreves miruje; izberite eno drevo ali brez vetra</translation>
    </message>
    <message>
        <source>a row of trees has no collision; choose one tree or none</source>
        <translation>vrsta dreves nima trkov; izberite eno drevo ali brez njih</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>samodejno</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nikoli</translation>
    </message>
    <message>
        <source>Sun colour</source>
        <translation>Barva sonca</translation>
    </message>
    <message>
        <source>Sky colour</source>
        <translation>Barva neba</translation>
    </message>
    <message>
        <source>leaves are spread along their stem as in the paper</source>
        <translation>listi so po veji razporejeni kot v članku</translation>
    </message>
    <message>
        <source>there it roughens the mesh of the trunk</source>
        <translation>tam nagrbanči mrežo debla</translation>
    </message>
    <message>
        <source>trunks lean by TrunksLean</source>
        <translation>debla se nagibajo po TrunksLean</translation>
    </message>
    <message>
        <source>trunks are turned by chance</source>
        <translation>debla so obrnjena naključno</translation>
    </message>
    <message>
        <source>of its shapes of discs and spheres an oval leaf is nearest</source>
        <translation>med njegovimi ploščami in kroglami je najbližji ovalen list</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be had: %2</source>
        <translation>»%1« ni mogoče prevzeti: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; becomes %2 = %3: %4</source>
        <translation>»%1« postane %2 = %3: %4</translation>
    </message>
    <message>
        <source>its shapes 8 and 10 have no formula here; the nearest is a tapered cylinder</source>
        <translation>njegovi obliki 8 in 10 tukaj nimata formule; najbližji je zožen valj</translation>
    </message>
    <message>
        <source>branches have no bare base here</source>
        <translation>veje tukaj nimajo golega dela</translation>
    </message>
    <message>
        <source>the trunk splits from its first segment on</source>
        <translation>deblo se cepi od prvega člena</translation>
    </message>
    <message>
        <source>splits are spread evenly</source>
        <translation>razcepi so enakomerno razporejeni</translation>
    </message>
    <message>
        <source>branches are as thick as RatioPower says</source>
        <translation>veje so tako debele, kot pravi RatioPower</translation>
    </message>
    <message>
        <source>branches are not drawn outwards here</source>
        <translation>veje se tukaj ne vlečejo navzven</translation>
    </message>
    <message>
        <source>branches are spread evenly along the trunk</source>
        <translation>veje so po deblu enakomerno razporejene</translation>
    </message>
    <message>
        <source>rings of branches are Whorl here</source>
        <translation>obroči vej so tukaj Whorl</translation>
    </message>
    <message>
        <source>the trunk does not thin towards branches</source>
        <translation>deblo se proti vejam ne tanjša</translation>
    </message>
    <message>
        <source>the envelope ends at the crown&apos;s base</source>
        <translation>ovojnica se konča ob vznožju krošnje</translation>
    </message>
    <message>
        <source>leaves of a stem are equally large</source>
        <translation>listi ene veje so enako veliki</translation>
    </message>
    <message>
        <source>leaves turn to the light by LeafBend</source>
        <translation>listi se proti svetlobi obračajo po LeafBend</translation>
    </message>
    <message>
        <source>a negative number there is a random one</source>
        <translation>negativno število tam pomeni naključno</translation>
    </message>
    <message>
        <source>stems bend by CurveV</source>
        <translation>stebla se upogibajo po CurveV</translation>
    </message>
    <message>
        <source>whorls are counted by their branches, and between alternate and opposite there is nothing</source>
        <translation>vretenca se štejejo po vejah in med izmeničnimi in nasprotnimi ni ničesar</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Stiskanje</translation>
    </message>
    <message>
        <source>%1 cannot be compressed; choose glTF</source>
        <translation>%1 ni mogoče stisniti; izberite glTF</translation>
    </message>
    <message>
        <source>what moves in the wind cannot be compressed</source>
        <translation>kar se giblje v vetru, ni mogoče stisniti</translation>
    </message>
    <message>
        <source>Quantised (KHR_mesh_quantization)</source>
        <translation>Kvantizirano (KHR_mesh_quantization)</translation>
    </message>
    <message>
        <source>Quantised, then meshopt (EXT_meshopt_compression)</source>
        <translation>Kvantizirano, nato meshopt (EXT_meshopt_compression)</translation>
    </message>
    <message>
        <source>Of glTF files: vertices in 16 and 8 bits, which most programs read, or these compressed by meshoptimizer as well, for web pages whose loader has its decoder.</source>
        <translation>Datoteke glTF: oglišča s 16 in 8 biti, ki jih bere večina programov, ali poleg tega stisnjena z meshoptimizerjem, za spletne strani, katerih nalagalnik ima njegov dekodirnik.</translation>
    </message>
    <message>
        <source>leaves that move in the wind cannot be instances</source>
        <translation>listi, ki se gibljejo v vetru, ne morejo biti instance</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instance</translation>
    </message>
    <message>
        <source>instances belong to one level of detail; choose a file for each</source>
        <translation>instance pripadajo eni ravni podrobnosti; izberite datoteko za vsako</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>JPEG where it can be</source>
        <translation>JPEG, kjer je mogoče</translation>
    </message>
    <message>
        <source>Texture format</source>
        <translation>Oblika tekstur</translation>
    </message>
    <message>
        <source>What pictures of bark colours are written as: JPEG has about a fifth of the bytes. Pictures with alpha, normals and roughness stay PNG.</source>
        <translation>V čem se zapišejo barve skorje: JPEG ima približno petino bajtov. Slike z alfo, normale in hrapavost ostanejo PNG.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Predmeti</translation>
    </message>
    <message>
        <source>Texture atlas</source>
        <translation>Atlas tekstur</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>materiali</translation>
    </message>
    <message>
        <source>texture coordinates</source>
        <translation>koordinate teksture</translation>
    </message>
    <message>
        <source>normals (programs make their own)</source>
        <translation>normale (programi naredijo svoje)</translation>
    </message>
    <message>
        <source>tangents</source>
        <translation>tangente</translation>
    </message>
    <message>
        <source>Blender and Godot do not read where leaves are transparent</source>
        <translation>Blender in Godot ne prebereta, kje so listi prosojni</translation>
    </message>
    <message>
        <source>all stems and leaves are one mesh</source>
        <translation>vse veje in listi so ena mreža</translation>
    </message>
    <message>
        <source>names end after ten letters; large meshes are cut into parts</source>
        <translation>imena se končajo po desetih črkah; velike mreže so razrezane na dele</translation>
    </message>
    <message>
        <source>a camera, lights and ground are added</source>
        <translation>dodani so kamera, luči in tla</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose no atlas, or level of detail 0 or 1</source>
        <translation>kartice rastočega drevesa kažejo v vsaki sličici drugo vejico; izberite brez atlasa ali raven podrobnosti 0 ali 1</translation>
    </message>
    <message>
        <source>Of glTF and USD files: one mesh for all leaves of a kind and a list of places instead of a copy for each, for programs that know it (EXT_mesh_gpu_instancing, PointInstancer). Normals are not rounded, and each leaf has one tint.</source>
        <translation>Za datoteke glTF in USD: ena mreža za vse liste iste vrste in seznam mest namesto kopije za vsakega, za programe, ki to poznajo (EXT_mesh_gpu_instancing, PointInstancer). Normale niso zaobljene in vsak list ima en odtenek.</translation>
    </message>
    <message>
        <source>Levels of detail are variants of the set LOD, which three.js does not read: choose a file for each</source>
        <translation>Ravni podrobnosti so različice nabora LOD, ki jih three.js ne bere: izberite datoteko za vsako</translation>
    </message>
    <message>
        <source>%1 cannot hold instances; choose glTF or USD</source>
        <translation>%1 ne more vsebovati instanc; izberite glTF ali USD</translation>
    </message>
    <message>
        <source>only PNG textures can go into an atlas, not %1</source>
        <translation>v atlas gredo le teksture PNG, ne %1</translation>
    </message>
    <message>
        <source>%1 repeats its texture (texture coordinates beyond 0 to 1), which an atlas cannot do</source>
        <translation>%1 ponavlja svojo teksturo (koordinate teksture zunaj 0 do 1), atlas tega ne zmore</translation>
    </message>
    <message>
        <source>By branch level</source>
        <translation>Po ravneh vej</translation>
    </message>
    <message>
        <source>By material</source>
        <translation>Po materialih</translation>
    </message>
    <message>
        <source>Leaves, blossoms and twigs</source>
        <translation>Listi, cvetovi in vejice</translation>
    </message>
    <message>
        <source>Separate objects for trunk, branches and leaves, or one object per material: fewer draw calls.</source>
        <translation>Ločeni predmeti za deblo, veje in liste ali en predmet na material: manj klicev risanja.</translation>
    </message>
    <message>
        <source>One material and one texture for leaves, blossoms and twigs: fewer draw calls. PNG textures only.</source>
        <translation>En material in ena tekstura za liste, cvetove in vejice: manj klicev risanja. Le teksture PNG.</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no atlas</source>
        <translation>%1 ne vsebuje tekstur, torej tudi atlasa ne</translation>
    </message>
    <message>
        <source>textures</source>
        <translation>teksture</translation>
    </message>
    <message>
        <source>opacity of leaves</source>
        <translation>prosojnost listov</translation>
    </message>
    <message>
        <source>normal maps</source>
        <translation>normalne mape</translation>
    </message>
    <message>
        <source>roughness maps</source>
        <translation>mape hrapavosti</translation>
    </message>
    <message>
        <source>leaf tints</source>
        <translation>odtenki listov</translation>
    </message>
    <message>
        <source>ambient occlusion (attribute)</source>
        <translation>ambientna zasenčenost (atribut)</translation>
    </message>
    <message>
        <source>the roughness maps lie beside the file</source>
        <translation>mape hrapavosti ležijo ob datoteki</translation>
    </message>
    <message>
        <source>frames of a motion have no impostor; choose one tree or none</source>
        <translation>sličice gibanja nimajo impostorja; izberite eno drevo ali nobenega</translation>
    </message>
    <message>
        <source>Cross of billboards</source>
        <translation>Križ panojev</translation>
    </message>
    <message>
        <source>Views from above the horizon (hemi-octahedral)</source>
        <translation>Pogledi nad obzorjem (hemioktaeder)</translation>
    </message>
    <message>
        <source>Views from all sides (octahedral)</source>
        <translation>Pogledi z vseh strani (oktaeder)</translation>
    </message>
    <message>
        <source>Impostor</source>
        <translation>Impostor</translation>
    </message>
    <message>
        <source>What stands for the tree when it is far: two crossed billboards as the last level of detail, or 8 × 8 views in an atlas beside the model (albedo, normal, depth), for a shader that shows the nearest.</source>
        <translation>Kar nadomesti drevo v daljavi: dva prekrižana panoja kot zadnja raven podrobnosti ali 8 × 8 pogledov v atlasu ob modelu (barva, normale, globina) za senčilnik, ki pokaže najbližje.</translation>
    </message>
    <message>
        <source>one solid has no impostor</source>
        <translation>eno samo telo nima impostorja</translation>
    </message>
    <message>
        <source>crossed billboards are the last level of detail; choose all levels of detail</source>
        <translation>prekrižana panoja sta zadnja raven podrobnosti; izberite vse ravni podrobnosti</translation>
    </message>
    <message>
        <source>%1 holds no textures, so no billboards</source>
        <translation>%1 ne nosi tekstur, torej tudi panojev ne</translation>
    </message>
    <message>
        <source>a row of trees has no impostor; choose one tree or none</source>
        <translation>vrsta dreves nima impostorja; izberite eno drevo ali nobenega</translation>
    </message>
    <message>
        <source>an impostor can be made of PNG textures only, not of %1</source>
        <translation>impostor je mogoče narediti le iz tekstur PNG, ne iz %1</translation>
    </message>
    <message>
        <source>Without overlap, for light maps</source>
        <translation>Brez prekrivanja, za svetlobne karte</translation>
    </message>
    <message>
        <source>Second UV</source>
        <translation>Drugi UV</translation>
    </message>
    <message>
        <source>A second set of texture coordinates, in which no two triangles share a place: for light maps, in glTF and FBX files.</source>
        <translation>Drugi nabor teksturnih koordinat, v katerem si nobena dva trikotnika ne delita mesta: za svetlobne karte, v datotekah glTF in FBX.</translation>
    </message>
    <message>
        <source>%1 holds one set of texture coordinates; choose glTF or FBX</source>
        <translation>%1 vsebuje en nabor teksturnih koordinat; izberite glTF ali FBX</translation>
    </message>
    <message>
        <source>one solid has no texture coordinates</source>
        <translation>eno telo nima teksturnih koordinat</translation>
    </message>
    <message>
        <source>the second texture coordinates hold the wind already</source>
        <translation>druge teksturne koordinate že vsebujejo veter</translation>
    </message>
    <message>
        <source>instances share their texture coordinates</source>
        <translation>primerki si delijo teksturne koordinate</translation>
    </message>
    <message>
        <source>instances (PointInstancer), levels of detail in one file (variants) and time samples are for programs that are built on OpenUSD: three.js shows none of them</source>
        <translation>primerki (PointInstancer), ravni podrobnosti v eni datoteki (variante) in časovni vzorci so za programe, ki temeljijo na OpenUSD: three.js ne prikaže ničesar od tega</translation>
    </message>
    <message>
        <source>%1 holds no time samples; choose USD</source>
        <translation>%1 ne vsebuje časovnih vzorcev; izberite USD</translation>
    </message>
    <message>
        <source>time samples belong to one level of detail; choose a file for each</source>
        <translation>časovni vzorci spadajo k eni ravni podrobnosti; izberite datoteko za vsako</translation>
    </message>
    <message>
        <source>cards of a growing tree show another twig in every frame; choose level of detail 0 or 1</source>
        <translation>kartice rastočega drevesa v vsaki sličici kažejo drugo vejico; izberite raven podrobnosti 0 ali 1</translation>
    </message>
</context>
<context>
    <name>stromar::CComparison</name>
    <message>
        <source>Kept; A shows it in place of what you make of it</source>
        <translation>Ohranjeno; tipka A ga pokaže namesto tega, kar iz njega naredite</translation>
    </message>
    <message>
        <source>Nothing was kept yet: Shift+A keeps the tree as it is</source>
        <translation>Nič še ni ohranjeno: Shift+A ohrani drevo, kakršno je</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prej</translation>
    </message>
</context>
<context>
    <name>stromar::CCurveEditor</name>
    <message>
        <source>value</source>
        <translation>vrednost</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>&amp;Izbriši točko</translation>
    </message>
</context>
<context>
    <name>stromar::CDockFolder</name>
    <message>
        <source>Folded docks</source>
        <translation>Zložene plošče</translation>
    </message>
</context>
<context>
    <name>stromar::CDocument</name>
    <message>
        <source>new.tree</source>
        <translation>novo.tree</translation>
    </message>
    <message>
        <source>Open preset %1</source>
        <translation>Odpri predlogo %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Obnovi</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neshranjene spremembe</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Uvoz %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportController</name>
    <message>
        <source>Writing %1</source>
        <translation>Zapisovanje %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
    <message>
        <source>Cannot export the tree</source>
        <translation>Drevesa ni mogoče izvoziti</translation>
    </message>
    <message>
        <source>Export cancelled; no file was changed</source>
        <translation>Izvoz preklican; nobena datoteka ni spremenjena</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Izvoženo %1</translation>
    </message>
</context>
<context>
    <name>stromar::CExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Izvoz</translation>
    </message>
    <message>
        <source>Lost in this format</source>
        <translation>V tem formatu se izgubi</translation>
    </message>
    <message>
        <source>Size, about</source>
        <translation>Velikost približno</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Prebrskaj…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datoteka</translation>
    </message>
    <message>
        <source>Where to export</source>
        <translation>Kam izvoziti</translation>
    </message>
    <message>
        <source>The file&apos;s name has to end in %1</source>
        <translation>Ime datoteke se mora končati na %1</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 že obstaja. Zamenjam?</translation>
    </message>
    <message>
        <source>%1, and what displacement adds</source>
        <translation>%1 in kar doda odmik površine</translation>
    </message>
    <message>
        <source>No program in particular</source>
        <translation>Noben določen program</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Naloži…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Shrani…</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Za</translation>
    </message>
    <message>
        <source>Load Export Settings</source>
        <translation>Naloži nastavitve izvoza</translation>
    </message>
    <message>
        <source>Export settings (*.export)</source>
        <translation>Nastavitve izvoza (*.export)</translation>
    </message>
    <message>
        <source>Cannot load the settings</source>
        <translation>Nastavitev ni mogoče naložiti</translation>
    </message>
    <message>
        <source>Save Export Settings</source>
        <translation>Shrani nastavitve izvoza</translation>
    </message>
    <message>
        <source>Cannot save the settings</source>
        <translation>Nastavitev ni mogoče shraniti</translation>
    </message>
    <message>
        <source>This tree alone</source>
        <translation>Samo to drevo</translation>
    </message>
    <message>
        <source>All %1 side by side, as one scene</source>
        <translation>Vseh %1 drugo ob drugem kot en prizor</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Drevesa</translation>
    </message>
</context>
<context>
    <name>stromar::CFallController</name>
    <message>
        <source>Fell the tree</source>
        <translation>Podri drevo</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Where it falls to: 0 to the right, 90 away from the front</source>
        <translation>Kam pade: 0 na desno, 90 proč od sprednje strani</translation>
    </message>
    <message>
        <source>Of the cut above the ground; 0 fells it with its foot</source>
        <translation>Višina reza nad tlemi; 0 ga podre z vznožjem</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Smer</translation>
    </message>
    <message>
        <source>&amp;Height of the cut</source>
        <translation>&amp;Višina reza</translation>
    </message>
    <message>
        <source>&amp;Fell</source>
        <translation>&amp;Podri</translation>
    </message>
</context>
<context>
    <name>stromar::CFileController</name>
    <message>
        <source>Trees (*.tree);;All files (*)</source>
        <translation>Drevesa (*.tree);;Vse datoteke (*)</translation>
    </message>
    <message>
        <source>Autosave: %1</source>
        <translation>Samodejno shranjevanje: %1</translation>
    </message>
    <message>
        <source>Cannot open the tree</source>
        <translation>Drevesa ni mogoče odpreti</translation>
    </message>
    <message>
        <source>Cannot open the preset</source>
        <translation>Predloge ni mogoče odpreti</translation>
    </message>
    <message>
        <source>Cannot save the tree</source>
        <translation>Drevesa ni mogoče shraniti</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Shranjeno %1</translation>
    </message>
    <message>
        <source>Open a tree</source>
        <translation>Odpri drevo</translation>
    </message>
    <message>
        <source>Save the tree</source>
        <translation>Shrani drevo</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Shrani kot predlogo</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Ime predloge</translation>
    </message>
    <message>
        <source>Replace the preset “%1”?</source>
        <translation>Zamenjam predlogo »%1«?</translation>
    </message>
    <message>
        <source>Cannot save the preset</source>
        <translation>Predloge ni mogoče shraniti</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;All files (*)</source>
        <translation>Slike (*.png *.jpg *.jpeg *.tga *.tif *.tiff *.bmp);;Vse datoteke (*)</translation>
    </message>
    <message>
        <source>As the &amp;bark</source>
        <translation>Kot &amp;lubje</translation>
    </message>
    <message>
        <source>As the &amp;leaf</source>
        <translation>Kot lis&amp;t</translation>
    </message>
    <message>
        <source>Another program has changed %1. Opening it again loses your changes.</source>
        <translation>Drug program je spremenil %1. Z novim odpiranjem izgubite svoje spremembe.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Drug program je spremenil %1.</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Odpri znova</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Obdrži moje</translation>
    </message>
    <message>
        <source>A tree that was never saved</source>
        <translation>Drevo, ki ni bilo nikoli shranjeno</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>Obnovi neshranjene spremembe</translation>
    </message>
    <message>
        <source>Stromar ended without saving these changes of %1:
%2</source>
        <translation>Stromar se je končal, ne da bi shranil te spremembe z dne %1:
%2</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Obnovi</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Zavrzi</translation>
    </message>
    <message>
        <source>Ask &amp;Later</source>
        <translation>Vprašaj &amp;pozneje</translation>
    </message>
    <message>
        <source>Cannot restore</source>
        <translation>Ni mogoče obnoviti</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neshranjene spremembe</translation>
    </message>
    <message>
        <source>Save the changes of %1?</source>
        <translation>Shranim spremembe v %1?</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.glb);;All files (*)</source>
        <translation>Mreže (*.obj *.glb);;Vse datoteke (*)</translation>
    </message>
    <message>
        <source>Changes from before a preset was opened are not saved; Undo brings them back. Go on without them?</source>
        <translation>Spremembe izpred odprtja predloge niso shranjene; Razveljavi jih povrne. Nadaljujem brez njih?</translation>
    </message>
    <message>
        <source>Cannot open the workshop</source>
        <translation>Delavnice ni mogoče odpreti</translation>
    </message>
    <message>
        <source>Cannot import the tree</source>
        <translation>Drevesa ni mogoče uvoziti</translation>
    </message>
    <message>
        <source>Trees of other programs</source>
        <translation>Drevesa drugih programov</translation>
    </message>
    <message>
        <source>Import a tree</source>
        <translation>Uvozi drevo</translation>
    </message>
</context>
<context>
    <name>stromar::CGrowthController</name>
    <message>
        <source>%1 = %2 fits</source>
        <translation>%1 = %2 ustreza</translation>
    </message>
    <message>
        <source>Grow it anyway</source>
        <translation>Vseeno zrasti</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Razveljavi</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Nazaj</translation>
    </message>
    <message>
        <source>Nothing has grown: this tree may have up to %1 stems, %2 leaves and %3 million vertices and take %4 GB of memory; the limit is %5 million vertices and %6 GB.</source>
        <translation>Nič ni zraslo: to drevo ima lahko do %1 vej, %2 listov in %3 milijonov oglišč ter porabi %4 GB pomnilnika; meja je %5 milijonov oglišč in %6 GB.</translation>
    </message>
</context>
<context>
    <name>stromar::CHelpWindow</name>
    <message>
        <source>Stromar Manual</source>
        <translation>Priročnik za Stromar</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strani</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Nazaj</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Naprej</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Vsebina</translation>
    </message>
</context>
<context>
    <name>stromar::CLanguageEditor</name>
    <message>
        <source>What is wrong</source>
        <translation>Kaj je narobe</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Najdi</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Uvozi…</translation>
    </message>
    <message>
        <source>Take the text of a file</source>
        <translation>Vzemi besedilo iz datoteke</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Izvozi…</translation>
    </message>
    <message>
        <source>Write the text to a file of its own</source>
        <translation>Zapiši besedilo v lastno datoteko</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>Odpni</translation>
    </message>
    <message>
        <source>Show the editor in a window of its own, or back in its tab</source>
        <translation>Pokaži urejevalnik v lastnem oknu ali nazaj v zavihku</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Korak</translation>
    </message>
    <message>
        <source>The word after this step</source>
        <translation>Beseda po tem koraku</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> od %1</translation>
    </message>
    <message>
        <source>Import a Text</source>
        <translation>Uvozi besedilo</translation>
    </message>
    <message>
        <source>Cannot import the text</source>
        <translation>Besedila ni mogoče uvoziti</translation>
    </message>
    <message>
        <source>Export the Text</source>
        <translation>Izvozi besedilo</translation>
    </message>
    <message>
        <source>Cannot export the text</source>
        <translation>Besedila ni mogoče izvoziti</translation>
    </message>
    <message>
        <source> … %1 more</source>
        <translation> … še %1</translation>
    </message>
    <message>
        <source>line %1 × %2</source>
        <translation>vrstica %1 × %2</translation>
    </message>
    <message>
        <source>No rule applies to this word.</source>
        <translation>Za to besedo ne velja nobeno pravilo.</translation>
    </message>
    <message>
        <source>To the next: %1</source>
        <translation>Do naslednje: %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Vse datoteke (*)</translation>
    </message>
    <message>
        <source>Attach</source>
        <translation>Pripni</translation>
    </message>
</context>
<context>
    <name>stromar::CLightPanel</name>
    <message>
        <source>Reset light</source>
        <translation>Ponastavi svetlobo</translation>
    </message>
    <message>
        <source>%1 stops</source>
        <translation>%1 zaslonk</translation>
    </message>
</context>
<context>
    <name>stromar::CMainWindow</name>
    <message>
        <source>Parameters</source>
        <translation>Parametri</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Predloge</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Različice</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Kot odprto</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Zgodovina</translation>
    </message>
    <message>
        <source>Messages of the file</source>
        <translation>Sporočila o datoteki</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Sporočila</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Orodja</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Odpri &amp;nedavne</translation>
    </message>
    <message>
        <source>Randomise</source>
        <translation>Premešaj</translation>
    </message>
    <message>
        <source>The graphics driver has started again</source>
        <translation>Grafični gonilnik se je znova zagnal</translation>
    </message>
    <message>
        <source>Stopped; F6 grows the full model</source>
        <translation>Ustavljeno; F6 zraste polni model</translation>
    </message>
    <message>
        <source>No manual</source>
        <translation>Ni priročnika</translation>
    </message>
    <message>
        <source>The pages of the manual are not installed.</source>
        <translation>Strani priročnika niso nameščene.</translation>
    </message>
    <message>
        <source>About Stromar</source>
        <translation>O programu Stromar</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Grows trees by the model of Weber and Penn, “Creation and Rendering of Realistic Trees”, SIGGRAPH ’95.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Stromar %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Goji drevesa po modelu Webra in Penna, »Creation and Rendering of Realistic Trees«, SIGGRAPH ’95.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Svetloba</translation>
    </message>
    <message>
        <source>New &amp;Tree by</source>
        <translation>Novo &amp;drevo po metodi</translation>
    </message>
    <message>
        <source>The tree is growing; Esc cancels</source>
        <translation>Drevo raste; Esc prekliče rast</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Veter</translation>
    </message>
    <message>
        <source>%1   %2   %3 leaves   %4 vertices   %5 triangles   %6 ms</source>
        <translation>%1   %2   %3 listov   %4 oglišč   %5 trikotnikov   %6 ms</translation>
    </message>
    <message>
        <source>Saved Cameras</source>
        <translation>Shranjeni pogledi</translation>
    </message>
    <message>
        <source>Nothing has grown yet</source>
        <translation>Nič še ni zraslo</translation>
    </message>
    <message>
        <source>No tree was found among these random values; a smaller amount finds some</source>
        <translation>Med temi naključnimi vrednostmi ni drevesa; manjša mera ga najde</translation>
    </message>
</context>
<context>
    <name>stromar::CMessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Zapri</translation>
    </message>
</context>
<context>
    <name>stromar::CParamEditor</name>
    <message>
        <source>Another tree of the same kind</source>
        <translation>Drugo drevo iste vrste</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Naključno seme</translation>
    </message>
</context>
<context>
    <name>stromar::CParamPanel</name>
    <message>
        <source>Find a parameter</source>
        <translation>Najdi parameter</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametri</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Naloži…</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Izberi sliko</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Nariši</translation>
    </message>
    <message>
        <source>A picture that Stromar draws; the words behind its name can be changed</source>
        <translation>Slika, ki jo nariše Stromar; besede za imenom je mogoče spremeniti</translation>
    </message>
    <message>
        <source>Texture Workshop…</source>
        <translation>Delavnica tekstur…</translation>
    </message>
    <message>
        <source>Choose a mesh</source>
        <translation>Izberite mrežo</translation>
    </message>
    <message>
        <source>Built in</source>
        <translation>Vgrajene</translation>
    </message>
    <message>
        <source>A mesh that comes with Stromar</source>
        <translation>Mreža, ki pride s Stromarjem</translation>
    </message>
    <message>
        <source>No parameter is called “%1”.</source>
        <translation>Noben parameter se ne imenuje »%1«.</translation>
    </message>
    <message>
        <source>Where they point</source>
        <translation>Kam kažejo</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Vrednosti</translation>
    </message>
    <message>
        <source>Copies, pastes and keeps the values of this tab; a right click on a heading does it with what stands below</source>
        <translation>Kopira, prilepi in ohrani vrednosti tega zavihka; desni klik na naslov naredi enako s tem, kar je pod njim</translation>
    </message>
</context>
<context>
    <name>stromar::CParamRow</name>
    <message>
        <source>Without effect: %1</source>
        <translation>Brez učinka: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Privzeto %1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Prilepi %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Prilepi</translation>
    </message>
    <message>
        <source>&amp;Reset to Default</source>
        <translation>P&amp;rivzeta vrednost</translation>
    </message>
    <message>
        <source>Back to the &amp;Saved Value</source>
        <translation>Nazaj na &amp;shranjeno vrednost</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Shranjeno %1</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiraj</translation>
    </message>
    <message>
        <source>&amp;Lock against Randomise</source>
        <translation>&amp;Zakleni pred mešanjem</translation>
    </message>
    <message>
        <source>Copy to &amp;Level</source>
        <translation>Kopiraj na &amp;raven</translation>
    </message>
</context>
<context>
    <name>stromar::CPictureDialog</name>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Prosojno ozadje</translation>
    </message>
    <message>
        <source>Save a Picture</source>
        <translation>Shrani sliko</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Ena slika</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> posnetkov</translation>
    </message>
    <message>
        <source>More than one: the tree turns once around, each frame a numbered PNG file</source>
        <translation>Več kot ena: drevo se enkrat zavrti, vsak posnetek je oštevilčena datoteka PNG</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Ši&amp;rina</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Višina</translation>
    </message>
    <message>
        <source>T&amp;urntable</source>
        <translation>Vr&amp;tenje</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg)</source>
        <translation>Slike (*.png *.jpg)</translation>
    </message>
</context>
<context>
    <name>stromar::CPreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Nastavitve</translation>
    </message>
    <message>
        <source>Clear the Picture Cache (%1)</source>
        <translation>Izprazni predpomnilnik slik (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CPresetBrowser</name>
    <message>
        <source>Find a tree</source>
        <translation>Najdi drevo</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Vse</translation>
    </message>
    <message>
        <source>Stromar&apos;s</source>
        <translation>Stromarjeve</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Moje</translation>
    </message>
    <message>
        <source>Folder of presets</source>
        <translation>Mapa predlog</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Shrani…</translation>
    </message>
    <message>
        <source>Keep the tree in the window as a preset of your own</source>
        <translation>Ohrani drevo v oknu kot lastno predlogo</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Predloge</translation>
    </message>
    <message>
        <source>By %1</source>
        <translation>Avtor: %1</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Odpri</translation>
    </message>
    <message>
        <source>&amp;Remove…</source>
        <translation>O&amp;dstrani…</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Odstrani predlogo</translation>
    </message>
    <message>
        <source>Move “%1” to the waste bin?</source>
        <translation>Premaknem »%1« v smetnjak?</translation>
    </message>
    <message>
        <source>%1 cannot be removed.</source>
        <translation>%1 ni mogoče odstraniti.</translation>
    </message>
    <message>
        <source>No presets yet: Save… keeps the tree in the window.</source>
        <translation>Predlog še ni: Shrani… ohrani drevo v oknu.</translation>
    </message>
    <message>
        <source>No preset is called “%1”.</source>
        <translation>Nobena predloga se ne imenuje »%1«.</translation>
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
        <translation>Posnemi</translation>
    </message>
    <message>
        <source>Growth, up to the age that is shown</source>
        <translation>Rast do prikazane starosti</translation>
    </message>
    <message>
        <source>Wind, in a loop</source>
        <translation>Veter v zanki</translation>
    </message>
    <message>
        <source>The fall</source>
        <translation>Padec</translation>
    </message>
    <message>
        <source>Numbered pictures (PNG)</source>
        <translation>Oštevilčene slike (PNG)</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>&amp;Kaj</translation>
    </message>
    <message>
        <source>Wid&amp;th</source>
        <translation>Ši&amp;rina</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Višina</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Dolžina</translation>
    </message>
    <message>
        <source>&amp;Frames per second</source>
        <translation>Sličic na &amp;sekundo</translation>
    </message>
    <message>
        <source>&amp;As</source>
        <translation>K&amp;ot</translation>
    </message>
    <message>
        <source>Video (MP4)</source>
        <translation>Video (MP4)</translation>
    </message>
    <message>
        <source>For videos, install ffmpeg.</source>
        <translation>Za videe namestite ffmpeg.</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>Videi (*.mp4)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Slike (*.png)</translation>
    </message>
</context>
<context>
    <name>stromar::CRecorder</name>
    <message>
        <source>Recording</source>
        <translation>Snemanje</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
    <message>
        <source>Recording cancelled; no file was changed</source>
        <translation>Snemanje preklicano; nobena datoteka ni spremenjena</translation>
    </message>
    <message numerus="yes">
        <source>Recording cancelled: %1 of %n frame(s) are saved</source>
        <translation>
            <numerusform>Snemanje preklicano: shranjenih %1 od %n sličice</numerusform>
            <numerusform>Snemanje preklicano: shranjenih %1 od %n sličic</numerusform>
            <numerusform>Snemanje preklicano: shranjenih %1 od %n sličic</numerusform>
            <numerusform>Snemanje preklicano: shranjenih %1 od %n sličic</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Shranjeno %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s)</source>
        <translation>
            <numerusform>Shranjena %n sličica</numerusform>
            <numerusform>Shranjeni %n sličici</numerusform>
            <numerusform>Shranjene %n sličice</numerusform>
            <numerusform>Shranjenih %n sličic</numerusform>
        </translation>
    </message>
    <message>
        <source>Cannot record</source>
        <translation>Snemanje ni mogoče</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 ni mogoče zapisati.</translation>
    </message>
    <message>
        <source>Making the video</source>
        <translation>Izdelava videa</translation>
    </message>
    <message>
        <source>ffmpeg could not make the video. %1</source>
        <translation>ffmpeg ni mogel izdelati videa. %1</translation>
    </message>
</context>
<context>
    <name>stromar::CSavedCameras</name>
    <message>
        <source>None yet: Save Camera keeps one</source>
        <translation>Ni še nobenega: ohrani ga Shrani pogled</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odstrani</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Pogled %1</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Shrani pogled</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Ime pogleda</translation>
    </message>
    <message>
        <source>There is a view called “%1” already. Replace it?</source>
        <translation>Pogled z imenom »%1« že obstaja. Naj se zamenja?</translation>
    </message>
</context>
<context>
    <name>stromar::CShortcutsDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Miška in tipke</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Kolesce</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>Bliže in dlje</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klik</translation>
    </message>
    <message>
        <source>Show details of the stem or leaf</source>
        <translation>Pokaži podrobnosti veje ali lista</translation>
    </message>
    <message>
        <source>Scroll; changes an editor only after a click into it</source>
        <translation>Drsi; vrednost spremeni šele po kliku vanjo</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Finer steps of a slider</source>
        <translation>Finejši koraki drsnika</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Larger steps of a slider</source>
        <translation>Večji koraki drsnika</translation>
    </message>
    <message>
        <source>Double click on a name</source>
        <translation>Dvojni klik na ime</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Nazaj na privzeto</translation>
    </message>
    <message>
        <source>Right click on a name</source>
        <translation>Desni klik na ime</translation>
    </message>
    <message>
        <source>Copy, paste, lock</source>
        <translation>Kopiraj, prilepi, zakleni</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>V sliki</translation>
    </message>
    <message>
        <source>In the parameters</source>
        <translation>V parametrih</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tipke</translation>
    </message>
</context>
<context>
    <name>stromar::CSideBySide</name>
    <message>
        <source>Age %1 %</source>
        <translation>Starost %1 %</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Preprosti</translation>
    </message>
    <message>
        <source>LOD %1</source>
        <translation>LOD %1</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>Trikotniki: %1</translation>
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
        <translation>Delavnica tekstur</translation>
    </message>
    <message>
        <source>Save Pictures…</source>
        <translation>Shrani slike…</translation>
    </message>
    <message>
        <source>Save Pictures</source>
        <translation>Shrani slike</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Slike (*.png)</translation>
    </message>
    <message>
        <source>Cannot save the pictures</source>
        <translation>Slik ni mogoče shraniti</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Slika</translation>
    </message>
</context>
<context>
    <name>stromar::CThumbnails</name>
    <message>
        <source>There is no OpenGL to draw it.</source>
        <translation>Ni OpenGL, ki bi ga narisal.</translation>
    </message>
</context>
<context>
    <name>stromar::CTimeline</name>
    <message>
        <source>A step back</source>
        <translation>Korak nazaj</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Predvajaj</translation>
    </message>
    <message>
        <source>A step forward</source>
        <translation>Korak naprej</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Starost</translation>
    </message>
    <message>
        <source>How old the tree is, or how far it has fallen</source>
        <translation>Kako staro je drevo ali kako daleč je padlo</translation>
    </message>
    <message>
        <source>Age %1 %</source>
        <translation>Starost %1 %</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Hitrost</translation>
    </message>
    <message>
        <source>How fast it is played</source>
        <translation>Kako hitro se predvaja</translation>
    </message>
    <message>
        <source>Begin anew at the end</source>
        <translation>Na koncu začni znova</translation>
    </message>
    <message>
        <source>Save pictures or a video of it</source>
        <translation>Shrani slike ali video</translation>
    </message>
    <message>
        <source>Fall %1 s</source>
        <translation>Padec %1 s</translation>
    </message>
</context>
<context>
    <name>stromar::CVariants</name>
    <message>
        <source>&amp;Nine Others</source>
        <translation>&amp;Devet drugih</translation>
    </message>
    <message>
        <source>Throw nine other seeds</source>
        <translation>Vrzi devet drugih semen</translation>
    </message>
    <message>
        <source>Liked seeds</source>
        <translation>Priljubljena semena</translation>
    </message>
    <message>
        <source>♥ Like</source>
        <translation>♥ Všeč</translation>
    </message>
    <message>
        <source>Keep the seed of the tree in the window in its file</source>
        <translation>Ohrani seme drevesa v oknu v njegovi datoteki</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Vse</translation>
    </message>
    <message>
        <source>&amp;Randomise</source>
        <translation>&amp;Premešaj</translation>
    </message>
    <message>
        <source>Move the values by chance; locked ones stay (right click a parameter to lock it)</source>
        <translation>Naključno premakne vrednosti; zaklenjene ostanejo (zaklene jih desni klik na parameter)</translation>
    </message>
    <message>
        <source>Random values</source>
        <translation>Naključne vrednosti</translation>
    </message>
    <message>
        <source>&amp;At most</source>
        <translation>&amp;Največ</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Seme %1</translation>
    </message>
    <message>
        <source>Ages</source>
        <translation>Starosti</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Age %1</source>
        <translation>Starost %1</translation>
    </message>
    <message>
        <source>The tree at this part of its life</source>
        <translation>Drevo v tem delu življenja</translation>
    </message>
    <message>
        <source>Values of</source>
        <translation>Vrednosti</translation>
    </message>
</context>
<context>
    <name>stromar::CViewController</name>
    <message>
        <source>Drag %1</source>
        <translation>Vlečenje: %1</translation>
    </message>
    <message>
        <source>%1, stem %2 of %3</source>
        <translation>%1, št. %2 od %3</translation>
    </message>
    <message>
        <source>Length %1, radius %2</source>
        <translation>Dolžina %1, polmer %2</translation>
    </message>
    <message>
        <source>On %1, stem %2, at %3</source>
        <translation>Na: %1, št. %2, pri %3</translation>
    </message>
    <message numerus="yes">
        <source>Split into %n path(s)</source>
        <translation>
            <numerusform>Deli se na %n pot</numerusform>
            <numerusform>Deli se na %n poti</numerusform>
            <numerusform>Deli se na %n poti</numerusform>
            <numerusform>Deli se na %n poti</numerusform>
        </translation>
    </message>
    <message>
        <source>Leaf %1 of %2
Length %3, width %4
On %5, stem %6</source>
        <translation>List %1 od %2
Dolžina %3, širina %4
Na: %5, št. %6</translation>
    </message>
    <message>
        <source>Height %1, width %2</source>
        <translation>Višina %1, širina %2</translation>
    </message>
    <message>
        <source>Leaves: %1, %2 triangles</source>
        <translation>Listi: %1, %2 trikotnikov</translation>
    </message>
    <message>
        <source>Structure %1 ms, mesh %2 ms</source>
        <translation>Struktura %1 ms, mreža %2 ms</translation>
    </message>
    <message>
        <source>Writing pictures</source>
        <translation>Zapisovanje slik</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
    <message>
        <source>Cannot save the picture</source>
        <translation>Slike ni mogoče shraniti</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 ni mogoče zapisati.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Shranjeno %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n frame(s) of a turntable</source>
        <translation>
            <numerusform>Shranjen %n posnetek vrtenja</numerusform>
            <numerusform>Shranjena %n posnetka vrtenja</numerusform>
            <numerusform>Shranjeni %n posnetki vrtenja</numerusform>
            <numerusform>Shranjenih %n posnetkov vrtenja</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Line %1 wrote %n segment(s)</source>
        <translation>
            <numerusform>Vrstica %1 je napisala %n odsek</numerusform>
            <numerusform>Vrstica %1 je napisala %n odseka</numerusform>
            <numerusform>Vrstica %1 je napisala %n odseke</numerusform>
            <numerusform>Vrstica %1 je napisala %n odsekov</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>This point touches %n branch(es)</source>
        <translation>
            <numerusform>Ta točka vpliva na %n vejo</numerusform>
            <numerusform>Ta točka vpliva na %n veji</numerusform>
            <numerusform>Ta točka vpliva na %n veje</numerusform>
            <numerusform>Ta točka vpliva na %n vej</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture Behind the Tree</source>
        <translation>Slika za drevesom</translation>
    </message>
    <message>
        <source>Pictures and HDRI panoramas (*.png *.jpg *.jpeg *.hdr)</source>
        <translation>Slike in panorame HDRI (*.png *.jpg *.jpeg *.hdr)</translation>
    </message>
    <message>
        <source>Cannot show the picture</source>
        <translation>Slike ni mogoče prikazati</translation>
    </message>
    <message>
        <source>%1: %2, %3 triangles</source>
        <translation>%1: %2, %3 trikotnikov</translation>
    </message>
    <message>
        <source>%1: %2 triangles, from %3 on</source>
        <translation>%1: %2 trikotnikov, od %3 naprej</translation>
    </message>
    <message>
        <source>Reference Picture</source>
        <translation>Referenčna slika</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Slike (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Height of what the picture shows, from edge to edge (%1)</source>
        <translation>Višina tega, kar kaže slika, od roba do roba (%1)</translation>
    </message>
</context>
<context>
    <name>stromar::CViewOverlay</name>
    <message>
        <source>Height %1</source>
        <translation>Višina %1</translation>
    </message>
    <message>
        <source>Before …</source>
        <translation>Prej …</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prej</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Zdaj</translation>
    </message>
</context>
<context>
    <name>stromar::CViewport</name>
    <message>
        <source>OpenGL 2.1 is needed to show the tree; this display has %1.%2. Files can still be edited and exported.</source>
        <translation>Za prikaz drevesa je potreben OpenGL 2.1; ta zaslon ima %1.%2. Datoteke je še vedno mogoče urejati in izvažati.</translation>
    </message>
    <message>
        <source>There is no OpenGL on this display, so the tree cannot be shown. Install your graphics driver. Files can still be edited and exported.</source>
        <translation>Na tem zaslonu ni OpenGL, zato drevesa ni mogoče pokazati. Namestite gonilnik za grafiko. Datoteke je še vedno mogoče urejati in izvažati.</translation>
    </message>
    <message>
        <source>Picture of the tree</source>
        <translation>Slika drevesa</translation>
    </message>
</context>
<context>
    <name>stromar::CWelcomeCard</name>
    <message>
        <source>Welcome to Stromar.</source>
        <translation>Dobrodošli v Stromarju.</translation>
    </message>
    <message>
        <source>Begin with a tree and change it:</source>
        <translation>Začnite z drevesom in ga spremenite:</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zapri</translation>
    </message>
    <message>
        <source>All Presets</source>
        <translation>Vse predloge</translation>
    </message>
    <message>
        <source>Open a File…</source>
        <translation>Odpri datoteko…</translation>
    </message>
    <message>
        <source>New Tree by</source>
        <translation>Novo drevo po</translation>
    </message>
</context>
<context>
    <name>stromar::CWindPanel</name>
    <message>
        <source>Breeze</source>
        <translation>Sapica</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Veter</translation>
    </message>
    <message>
        <source>Gale</source>
        <translation>Vihar</translation>
    </message>
    <message>
        <source>S&amp;way in the wind</source>
        <translation>&amp;Zibanje v vetru</translation>
    </message>
    <message>
        <source>Flexibility: %1</source>
        <translation>Prožnost: %1</translation>
    </message>
</context>
</TS>
