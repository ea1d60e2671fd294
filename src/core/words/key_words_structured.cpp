// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_key_words_structured = std::to_array<WordRow>({
    {"Content of the release: fluid alone, or blocks of solids with confined fluid.",
     "Contenuto del distacco: solo fluido, o blocchi di solidi con fluido confinato.",
     "Inhalt des Anrisses: nur Fluid oder Blöcke aus Feststoffen mit gebundenem Fluid.",
     "Contenu au départ\u202F: fluide seul, ou blocs de solides avec fluide confiné.",
     "Contenido del inicio: solo fluido, o bloques de sólidos con fluido confinado."},
    {"Density of the fluid.", "Densità del fluido.", "Dichte des Fluids.", "Masse volumique du fluide.",
     "Densidad del fluido."},
    {"Dynamic viscosity of the fluid: shear in the plane and at the bed; 0: none.",
     "Viscosità dinamica del fluido: taglio nel piano e al fondo; 0: nessuna.",
     "Dynamische Viskosität des Fluids: Scherung in der Ebene und an der Sohle; 0: keine.",
     "Viscosité dynamique du fluide\u202F: cisaillement dans le plan et au lit\u202F; 0\u202F: aucune.",
     "Viscosidad dinámica del fluido: corte en el plano y en el lecho; 0: ninguna."},
    {"Shape of the velocity over depth, chi, in the viscous shear at the bed.",
     "Forma della velocità sulla profondità, chi, nel taglio viscoso al fondo.",
     "Form der Geschwindigkeit über der Tiefe, chi, in der viskosen Scherung an der Sohle.",
     "Forme de la vitesse sur la hauteur, chi, dans le cisaillement visqueux au lit.",
     "Forma de la velocidad sobre la profundidad, chi, en el corte viscoso en el lecho."},
    {"Manning's n of the ground under free fluid; 0: smooth.",
     "n di Manning del terreno sotto il fluido libero; 0: liscio.",
     "n nach Manning des Geländes unter freiem Fluid; 0: glatt.",
     "n de Manning du terrain sous le fluide libre\u202F; 0\u202F: lisse.",
     "n de Manning del terreno bajo el fluido libre; 0: liso."},
    {"Depth in Manning's law where there are solids: of the free fluid, or of solids and fluid as far as they move "
     "together.",
     "Profondità nella legge di Manning dove ci sono solidi: del fluido libero, o di solidi e fluido per quanto si "
     "muovono insieme.",
     "Tiefe im Gesetz von Manning, wo Feststoffe sind: die des freien Fluids oder die von Feststoffen und Fluid, "
     "soweit sie sich gemeinsam bewegen.",
     "Hauteur dans la loi de Manning là où il y a des solides\u202F: celle du fluide libre, ou celle des solides et du "
     "fluide dans la mesure où ils se meuvent ensemble.",
     "Profundidad en la ley de Manning donde hay sólidos: la del fluido libre, o la de sólidos y fluido en la medida "
     "en que se mueven juntos."},
    {"Depth of free fluid on the ground or on the solids at the start, in addition to the release.",
     "Profondità del fluido libero sul terreno o sui solidi all’inizio, in aggiunta al distacco.",
     "Tiefe des freien Fluids auf dem Gelände oder den Feststoffen am Anfang, zusätzlich zum Anriss.",
     "Hauteur de fluide libre sur le terrain ou sur les solides au début, en plus de la masse au départ.",
     "Profundidad de fluido libre sobre el terreno o los sólidos al inicio, además de la masa inicial."},
    {"Depth below which free fluid does not move.", "Profondità sotto la quale il fluido libero non si muove.",
     "Tiefe, unter der sich freies Fluid nicht bewegt.", "Hauteur au-dessous de laquelle le fluide libre ne bouge pas.",
     "Profundidad por debajo de la cual el fluido libre no se mueve."},
    {"Volume fraction of solids in the release; the rest is fluid.",
     "Frazione in volume dei solidi nel distacco; il resto è fluido.",
     "Volumenanteil der Feststoffe im Anriss; der Rest ist Fluid.",
     "Fraction volumique des solides au départ\u202F; le reste est du fluide.",
     "Fracción en volumen de sólidos en el inicio; el resto es fluido."},
    {"Fraction of that fluid that is confined by the structure; the rest is free from the start.",
     "Frazione di quel fluido che è confinata dalla struttura; il resto è libero dall’inizio.",
     "Anteil dieses Fluids, den das Gefüge bindet; der Rest ist von Anfang an frei.",
     "Fraction de ce fluide confinée par la structure\u202F; le reste est libre dès le début.",
     "Fracción de ese fluido confinada por la estructura; el resto es libre desde el inicio."},
    {"Density of the grains.", "Densità dei grani.", "Korndichte der Feststoffe.", "Masse volumique des grains.",
     "Densidad de los granos."},
    {"Diameter of the grains, for the drag.", "Diametro dei grani, per la resistenza di trascinamento.",
     "Korndurchmesser, für den Strömungswiderstand.", "Diamètre des grains, pour la traînée.",
     "Diámetro de los granos, para el arrastre."},
    {"Cohesion of the intact material; 0: loose from the start.",
     "Coesione del materiale intatto; 0: sciolto dall’inizio.",
     "Kohäsion des intakten Materials; 0: von Anfang an locker.",
     "Cohésion du matériau intact\u202F; 0\u202F: meuble dès le début.",
     "Cohesión del material intacto; 0: suelto desde el inicio."},
    {"Internal friction angle.", "Angolo di attrito interno.", "Innerer Reibungswinkel.",
     "Angle de frottement interne.", "Ángulo de fricción interna."},
    {"Friction angle at the bed.", "Angolo di attrito al fondo.", "Reibungswinkel an der Sohle.",
     "Angle de frottement au lit.", "Ángulo de fricción en el lecho."},
    {"Polygons, in their own CRS, for attribute:NAME in this section.",
     "Poligoni, nel proprio SR, per attribute:NAME in questa sezione.",
     "Polygone, in eigenem KBS, für attribute:NAME in diesem Abschnitt.",
     "Polygones, dans leur propre SCR, pour attribute:NAME dans cette section.",
     "Polígonos, en su propio SRC, para attribute:NAME en esta sección."},
    {"Particle positions at the start: on a square lattice, or along the R2 sequence with as many per cell as its "
     "depth requires.",
     "Posizioni delle particelle all’inizio: su un reticolo quadrato, o lungo la sequenza R2 con tante per cella "
     "quante ne richiede la sua profondità.",
     "Lage der Partikel am Anfang: auf einem quadratischen Gitter oder entlang der R2-Folge mit so vielen je Zelle, "
     "wie deren Tiefe erfordert.",
     "Positions des particules au début\u202F: sur un réseau carré, ou le long de la suite R2 avec autant par maille "
     "que sa hauteur l’exige.",
     "Posiciones de las partículas al inicio: en una retícula cuadrada, o según la secuencia R2 con tantas por celda "
     "como exige su profundidad."},
    {"Dilatancy angle of plastic flow; with a larger one, a column pressed from its sides would widen without end.",
     "Angolo di dilatanza del flusso plastico; con uno maggiore, una colonna compressa dai lati si allargherebbe senza "
     "fine.",
     "Dilatanzwinkel des plastischen Fließens; mit einem größeren würde eine seitlich gedrückte Säule ohne Ende "
     "breiter.",
     "Angle de dilatance de l’écoulement plastique\u202F; avec un angle plus grand, une colonne pressée sur ses côtés "
     "s’élargirait sans fin.",
     "Ángulo de dilatancia del flujo plástico; con uno mayor, una columna comprimida por los lados se ensancharía sin "
     "fin."},
    {"Young's modulus E; under 9 times the bulk modulus.",
     "Modulo di Young E; meno di 9 volte il modulo di comprimibilità.",
     "Elastizitätsmodul E; unter dem 9-fachen Kompressionsmodul.",
     "Module de Young E\u202F; moins de 9 fois le module de compressibilité.",
     "Módulo de Young E; menos de 9 veces el módulo de compresibilidad."},
    {"Bulk modulus K. Stiffer material takes more substeps.",
     "Modulo di comprimibilità K. Un materiale più rigido richiede più sottopassi.",
     "Kompressionsmodul K. Steiferes Material braucht mehr Teilschritte.",
     "Module de compressibilité K. Un matériau plus raide demande plus de sous-pas.",
     "Módulo de compresibilidad K. Un material más rígido requiere más subpasos."},
    {"Strain of yielding material at which half of the cohesion is lost.",
     "Deformazione del materiale che cede, alla quale è persa metà della coesione.",
     "Dehnung fließenden Materials, bei der die halbe Kohäsion verloren ist.",
     "Déformation du matériau qui cède à laquelle la moitié de la cohésion est perdue.",
     "Deformación del material que cede a la que se pierde la mitad de la cohesión."},
    {"Strain measure for critical-strain: distortion, or volumetric opening alone.",
     "Misura di deformazione per critical-strain: distorsione, o sola apertura volumetrica.",
     "Dehnungsmaß für critical-strain: Verzerrung oder allein die volumetrische Öffnung.",
     "Mesure de déformation pour critical-strain\u202F: distorsion, ou seule ouverture volumique.",
     "Medida de deformación para critical-strain: distorsión, o solo apertura volumétrica."},
    {"Structured fraction of the solids in intact material.", "Frazione strutturata dei solidi nel materiale intatto.",
     "Strukturierter Anteil der Feststoffe im intakten Material.",
     "Fraction structurée des solides dans le matériau intact.",
     "Fracción estructurada de los sólidos en el material intacto."},
    {"Stress in the yield check: total, with the overburden and the vertical stress of the weight, or the particle's "
     "elastic stress alone.",
     "Tensione nella verifica di plasticità: totale, con il sovraccarico e la tensione verticale del peso, o la sola "
     "tensione elastica della particella.",
     "Spannung in der Prüfung auf Fließen: gesamte, mit Auflast und Vertikalspannung des Gewichts, oder allein die "
     "elastische Spannung des Partikels.",
     "Contrainte dans la vérification de plasticité\u202F: totale, avec la surcharge et la contrainte verticale du "
     "poids, ou seule contrainte élastique de la particule.",
     "Tensión en la comprobación de fluencia: total, con la sobrecarga y la tensión vertical del peso, o solo la "
     "tensión elástica de la partícula."},
    {"Stress of material without cohesion: earth pressure, or elastic and frictional as in intact material.",
     "Tensione del materiale senza coesione: spinta delle terre, o elastica e attritiva come nel materiale intatto.",
     "Spannung von Material ohne Kohäsion: Erddruck, oder elastisch und reibend wie im intakten Material.",
     "Contrainte du matériau sans cohésion\u202F: poussée des terres, ou élastique et frottante comme dans le matériau "
     "intact.",
     "Tensión del material sin cohesión: empuje de tierras, o elástica y friccional como en el material intacto."},
    {"Lateral thrust of the load beyond the strength: hydrostatic, Bell's active one, or also passive in compression.",
     "Spinta laterale del carico oltre la resistenza: idrostatica, attiva secondo Bell, o anche passiva in "
     "compressione.",
     "Seitendruck der Last über die Festigkeit hinaus: hydrostatisch, aktiv nach Bell oder bei Stauchung auch passiv.",
     "Poussée latérale de la charge au-delà de la résistance\u202F: hydrostatique, active selon Bell, ou aussi passive "
     "en compression.",
     "Empuje lateral de la carga más allá de la resistencia: hidrostático, activo según Bell, o también pasivo en "
     "compresión."},
    {"Fraction B of the confined fluid's pressure that reaches the bed.",
     "Frazione B della pressione del fluido confinato che arriva al fondo.",
     "Anteil B des Drucks des gebundenen Fluids, der die Sohle erreicht.",
     "Fraction B de la pression du fluide confiné qui atteint le lit.",
     "Fracción B de la presión del fluido confinado que llega al lecho."},
    {"Linear artificial viscosity between particles.", "Viscosità artificiale lineare fra le particelle.",
     "Lineare künstliche Viskosität zwischen Partikeln.", "Viscosité artificielle linéaire entre particules.",
     "Viscosidad artificial lineal entre partículas."},
    {"Quadratic artificial viscosity between particles.", "Viscosità artificiale quadratica fra le particelle.",
     "Quadratische künstliche Viskosität zwischen Partikeln.", "Viscosité artificielle quadratique entre particules.",
     "Viscosidad artificial cuadrática entre partículas."},
    {"Speed of sound in the artificial viscosity.", "Velocità del suono nella viscosità artificiale.",
     "Schallgeschwindigkeit in der künstlichen Viskosität.", "Vitesse du son dans la viscosité artificielle.",
     "Velocidad del sonido en la viscosidad artificial."},
    {"Divides both moduli; elastic waves are slower by its square root, and substeps longer by the same factor. At "
     "most so that the elastic strain at the strength is a twentieth of critical-strain.",
     "Divide entrambi i moduli; le onde elastiche sono più lente della sua radice quadrata e i sottopassi più lunghi "
     "dello stesso fattore. Al massimo tale che la deformazione elastica alla resistenza sia un ventesimo di "
     "critical-strain.",
     "Teilt beide Moduln; elastische Wellen werden um seine Wurzel langsamer und Teilschritte um denselben Faktor "
     "länger. Höchstens so, dass die elastische Dehnung bei der Festigkeit ein Zwanzigstel von critical-strain ist.",
     "Divise les deux modules\u202F; les ondes élastiques sont ralenties de sa racine carrée, et les sous-pas allongés "
     "du même facteur. Au plus tel que la déformation élastique à la résistance soit un vingtième de critical-strain.",
     "Divide ambos módulos; las ondas elásticas son más lentas en su raíz cuadrada, y los subpasos más largos en el "
     "mismo factor. Como máximo tal que la deformación elástica en la resistencia sea un vigésimo de critical-strain."},
    {"PIC fraction of the grid velocity that solids take over in a step.",
     "Frazione PIC della velocità della griglia che i solidi assumono in un passo.",
     "PIC-Anteil der Gittergeschwindigkeit, den die Feststoffe in einem Schritt übernehmen.",
     "Fraction PIC de la vitesse de la grille que les solides reprennent en un pas.",
     "Fracción PIC de la velocidad de la malla que los sólidos adoptan en un paso."},
    {"Strength of the artificial stress against clumping in tension.",
     "Intensità della tensione artificiale contro l’addensarsi in trazione.",
     "Stärke der künstlichen Spannung gegen das Verklumpen unter Zug.",
     "Intensité de la contrainte artificielle contre l’agglutination en traction.",
     "Intensidad de la tensión artificial contra el apelmazamiento en tracción."},
    {"Drag is linear (1) or quadratic (2) in the relative velocity.",
     "La resistenza di trascinamento è lineare (1) o quadratica (2) nella velocità relativa.",
     "Der Strömungswiderstand ist linear (1) oder quadratisch (2) in der Relativgeschwindigkeit.",
     "La traînée est linéaire (1) ou quadratique (2) en la vitesse relative.",
     "El arrastre es lineal (1) o cuadrático (2) en la velocidad relativa."},
    {"Richardson and Zaki's exponent M of hindered settling.",
     "Esponente M di Richardson e Zaki della sedimentazione ostacolata.",
     "Exponent M der behinderten Sedimentation nach Richardson und Zaki.",
     "Exposant M de la sédimentation freinée de Richardson et Zaki.",
     "Exponente M de la sedimentación impedida de Richardson y Zaki."},
    {"Exponent M: constant, or from the grains' Reynolds number.",
     "Esponente M: costante, o dal numero di Reynolds dei grani.",
     "Exponent M: konstant oder aus der Reynolds-Zahl der Körner.",
     "Exposant M\u202F: constant, ou selon le nombre de Reynolds des grains.",
     "Exponente M: constante, o según el número de Reynolds de los granos."},
    {"K of the drag's smoothing term; 0: the mixture's flux.",
     "K del termine di regolarizzazione del trascinamento; 0: il flusso della miscela.",
     "K des Glättungsterms des Strömungswiderstands; 0: der Fluss des Gemischs.",
     "K du terme de lissage de la traînée\u202F; 0\u202F: le flux du mélange.",
     "K del término de suavizado del arrastre; 0: el flujo de la mezcla."},
    {"Fluid-like fraction P of the drag: from the loose fractions of solids and fluid, or from the solid fraction.",
     "Frazione P del trascinamento di tipo fluido: dalle frazioni sciolte di solidi e fluido, o dalla frazione solida.",
     "Fluidartiger Anteil P des Strömungswiderstands: aus den lockeren Anteilen von Feststoffen und Fluid oder aus dem "
     "Feststoffanteil.",
     "Part P de la traînée de type fluide\u202F: d’après les fractions libres de solides et de fluide, ou d’après la "
     "fraction solide.",
     "Fracción P del arrastre de tipo fluido: según las fracciones sueltas de sólidos y fluido, o según la fracción de "
     "sólidos."},
    {"Exponent of the fluid-like fraction.", "Esponente della frazione di tipo fluido.",
     "Exponent des fluidartigen Anteils.", "Exposant de la part de type fluide.",
     "Exponente de la fracción de tipo fluido."},
    {"Size of structured blocks, for the drag.",
     "Dimensione dei blocchi strutturati, per la resistenza di trascinamento.",
     "Größe strukturierter Blöcke, für den Strömungswiderstand.", "Taille des blocs structurés, pour la traînée.",
     "Tamaño de los bloques estructurados, para el arrastre."},
    {"Law of the virtual mass of fluid that accelerates with the solids.",
     "Legge della massa virtuale del fluido che accelera con i solidi.",
     "Gesetz der virtuellen Masse des Fluids, das mit den Feststoffen beschleunigt wird.",
     "Loi de la masse virtuelle du fluide qui accélère avec les solides.",
     "Ley de la masa virtual del fluido que se acelera con los sólidos."},
    {"Growth of the viscosity with the solid fraction, b in a exp(b alpha).",
     "Crescita della viscosità con la frazione solida, b in a exp(b alpha).",
     "Zunahme der Viskosität mit dem Feststoffanteil, b in a exp(b alpha).",
     "Croissance de la viscosité avec la fraction solide, b dans a exp(b alpha).",
     "Crecimiento de la viscosidad con la fracción de sólidos, b en a exp(b alpha)."},
    {"Mobility of the interface in the enhanced stress; 0: no such stress.",
     "Mobilità dell’interfaccia nella tensione aumentata; 0: senza questa tensione.",
     "Mobilität der Grenzfläche in der erweiterten Spannung; 0: ohne diese Spannung.",
     "Mobilité de l’interface dans la contrainte augmentée\u202F; 0\u202F: sans cette contrainte.",
     "Movilidad de la interfaz en la tensión aumentada; 0: sin esta tensión."},
    {"Shape of the solid fraction over depth, zeta.", "Forma della frazione solida sulla profondità, zeta.",
     "Form des Feststoffanteils über der Tiefe, zeta.", "Forme de la fraction solide sur la hauteur, zeta.",
     "Forma de la fracción de sólidos sobre la profundidad, zeta."},
});

}  // namespace

std::span<const WordRow> key_words_structured() {
    return k_key_words_structured;
}

}  // namespace frana
