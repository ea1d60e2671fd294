// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_input_warning_words = std::to_array<WordRow>({
    // How warnings are put together.
    {"{1}: {2}", "{1}: {2}", "{1}: {2}", "{1}\u202F: {2}", "{1}: {2}"},
    {"{1}; {2}", "{1}; {2}", "{1}; {2}", "{1}\u202F; {2}", "{1}; {2}"},
    {"{1} ({2} %)", "{1} ({2} %)", "{1} ({2} %)", "{1} ({2}\u202F%)", "{1} ({2} %)"},
    {"{1} and {2} more", "{1} e altri {2}", "{1} und {2} weitere", "{1} et {2} autres", "{1} y {2} más"},
    {"{1}; and {2} more of this kind", "{1}; e altri {2} dello stesso tipo", "{1}; und {2} weitere dieser Art",
     "{1}\u202F; et {2} autres du même genre", "{1}; y {2} más de este tipo"},
    // Inputs.
    {"zones", "zone", "Zonen", "zones", "zonas"},
    {"observed outline", "perimetro osservato", "beobachteter Umriss", "contour observé", "contorno observado"},
    {"thickness", "spessore", "Mächtigkeit", "épaisseur", "espesor"},
    {"thickness {1}", "spessore {1}", "Mächtigkeit {1}", "épaisseur {1}", "espesor {1}"},
    {"perimeter", "perimetro", "Umriss", "périmètre", "perímetro"},
    {"inflow line", "linea di afflusso", "Zuflusslinie", "ligne d’afflux", "línea de entrada"},
    {"{1} is now called {2}: a later version will refuse the former name",
     "{1} ora si chiama {2}: una versione futura rifiuterà il vecchio nome",
     "{1} heißt jetzt {2}: eine spätere Version wird den früheren Namen ablehnen",
     "{1} s’appelle désormais {2}\u202F: une version ultérieure refusera l’ancien nom",
     "{1} se llama ahora {2}: una versión posterior rechazará el nombre anterior"},
    // Coordinates: src/app/input/choose_crs.cpp, transform_report.cpp.
    {"{1} to {2} by direction", "da {1} a {2} secondo la direzione", "{1} bis {2} je nach Richtung",
     "{1} à {2} selon la direction", "{1} a {2} según la dirección"},
    {"DTM: lengths in {1} are not lengths on the ground (scale {2}); the run is computed in the UTM zone instead",
     "DTM: le lunghezze in {1} non sono lunghezze sul terreno (scala {2}); il calcolo si svolge invece nella zona UTM",
     "DGM: Längen in {1} sind keine Längen im Gelände (Maßstab {2}); gerechnet wird stattdessen in der UTM-Zone",
     "MNT\u202F: les longueurs en {1} ne sont pas des longueurs sur le terrain (échelle {2})\u202F; le calcul se fait "
     "dans la zone UTM",
     "MDT: las longitudes en {1} no son longitudes sobre el terreno (escala {2}); el cálculo se hace en la zona UTM"},
    {"{1}: the accuracy of its transformation is unknown ({2}); its position may be wrong by metres to hundreds of "
     "metres",
     "{1}: l’accuratezza della trasformazione è sconosciuta ({2}); la posizione può essere errata da metri a centinaia "
     "di metri",
     "{1}: die Genauigkeit der Transformation ist unbekannt ({2}); die Lage kann um Meter bis Hunderte von Metern "
     "falsch sein",
     "{1}\u202F: l’exactitude de sa transformation est inconnue ({2})\u202F; sa position peut être fausse de quelques "
     "mètres à des centaines de mètres",
     "{1}: la exactitud de su transformación se desconoce ({2}); su posición puede estar errada de metros a cientos de "
     "metros"},
    {"{1}: its position is accurate to {2} m only; half a cell is {3} m ({4})",
     "{1}: la posizione è accurata solo entro {2} m; mezza cella è {3} m ({4})",
     "{1}: die Lage ist nur auf {2} m genau; eine halbe Zelle misst {3} m ({4})",
     "{1}\u202F: sa position n’est exacte qu’à {2} m près\u202F; une demi-maille mesure {3} m ({4})",
     "{1}: su posición solo es exacta hasta {2} m; media celda mide {3} m ({4})"},
    {"a more accurate transformation", "una trasformazione più accurata", "eine genauere Transformation",
     "une transformation plus exacte", "una transformación más exacta"},
    {"a more accurate transformation ({1} m)", "una trasformazione più accurata ({1} m)",
     "eine genauere Transformation ({1} m)", "une transformation plus exacte ({1} m)",
     "una transformación más exacta ({1} m)"},
    {"{1}: {2} needs a grid file which is not installed (see Debian's proj-data, or projsync)",
     "{1}: {2} richiede un file di griglia che non è installato (vedi proj-data di Debian, o projsync)",
     "{1}: {2} braucht eine Gitterdatei, die nicht installiert ist (siehe proj-data von Debian oder projsync)",
     "{1}\u202F: {2} demande un fichier de grille qui n’est pas installé (voir proj-data de Debian, ou projsync)",
     "{1}: {2} necesita un archivo de rejilla que no está instalado (véase proj-data de Debian, o projsync)"},
    {"{1}: {2} needs the grid file {3}, which is not installed (see Debian's proj-data, or projsync)",
     "{1}: {2} richiede il file di griglia {3}, che non è installato (vedi proj-data di Debian, o projsync)",
     "{1}: {2} braucht die Gitterdatei {3}, die nicht installiert ist (siehe proj-data von Debian oder projsync)",
     "{1}\u202F: {2} demande le fichier de grille {3}, qui n’est pas installé (voir proj-data de Debian, ou projsync)",
     "{1}: {2} necesita el archivo de rejilla {3}, que no está instalado (véase proj-data de Debian, o projsync)"},
    // Release: src/app/input/check_release.cpp, thickness_volume.cpp, thin_release.cpp.
    {"row {1} column {2} at {3}", "riga {1} colonna {2} a {3}", "Zeile {1} Spalte {2} bei {3}",
     "ligne {1} colonne {2} en {3}", "fila {1} columna {2} en {3}"},
    {"{1} cell: {2}", "{1} cella: {2}", "{1} Zelle: {2}", "{1} maille\u202F: {2}", "{1} celda: {2}"},
    {"{1} cells: {2}", "{1} celle: {2}", "{1} Zellen: {2}", "{1} mailles\u202F: {2}", "{1} celdas: {2}"},
    {"the thickness raster has no value on part of the perimeter, nothing is released there: {1}",
     "il raster dello spessore non ha valore su parte del perimetro, lì non si stacca nulla: {1}",
     "das Mächtigkeitsraster hat in einem Teil des Umrisses keinen Wert, dort bricht nichts los: {1}",
     "le raster d’épaisseur n’a pas de valeur sur une partie du périmètre, rien n’y part\u202F: {1}",
     "el ráster de espesor no tiene valor en parte del perímetro, ahí no se libera nada: {1}"},
    {"the DTM lies at {1} % of the way from the elevations after the failure to those before it (release.thickness): "
     "neither of the two. Check that all three are of the same place and height system",
     "il DTM sta al {1} % tra le quote dopo il distacco e quelle prima (release.thickness): nessuna delle due. "
     "Controllare che tutti e tre siano dello stesso luogo e sistema altimetrico",
     "das DGM liegt bei {1} % des Weges von den Höhen nach dem Abbruch zu denen davor (release.thickness): keines von "
     "beiden. Zu prüfen ist, ob alle drei vom selben Ort und Höhensystem sind",
     "le MNT se trouve à {1}\u202F% entre les altitudes d’après la rupture et celles d’avant "
     "(release.thickness)\u202F: ni l’un ni l’autre. Vérifier que les trois sont du même lieu et du même système "
     "altimétrique",
     "el MDT está al {1} % entre las cotas de después de la rotura y las de antes (release.thickness): ninguna de las "
     "dos. Compruebe que los tres sean del mismo lugar y sistema de alturas"},
    {"polygons of the perimeter overlap, their thicknesses add up there: {1}",
     "poligoni del perimetro si sovrappongono, lì i loro spessori si sommano: {1}",
     "Polygone des Umrisses überlappen sich, dort addieren sich ihre Mächtigkeiten: {1}",
     "des polygones du périmètre se recouvrent, leurs épaisseurs s’y ajoutent\u202F: {1}",
     "polígonos del perímetro se superponen, ahí se suman sus espesores: {1}"},
    {"{1} is nearly the release ({2} % of the cells of either are in both): it must be the outline of all the ground "
     "that the event covered, not that of its source alone",
     "{1} è quasi l’area di distacco (il {2} % delle celle dell’una o dell’altra sta in entrambe): deve essere il "
     "perimetro di tutto il terreno coperto dall’evento, non quello della sola zona di distacco",
     "{1} ist fast die Anrissfläche ({2} % der Zellen beider liegen in beiden): es muss der Umriss des gesamten vom "
     "Ereignis bedeckten Geländes sein, nicht nur der des Anrisses",
     "{1} est presque la zone de départ ({2}\u202F% des mailles de l’un ou de l’autre sont dans les deux)\u202F: ce "
     "doit être le contour de tout le terrain couvert par l’événement, non celui de la seule zone de départ",
     "{1} es casi el área de inicio ({2} % de las celdas de uno u otro están en ambos): debe ser el contorno de todo "
     "el terreno que cubrió el evento, no solo el del área de inicio"},
    {"{1} of {2} exposed features are off the map or on ground without elevation, the first is {3}: the result will "
     "say "
     "nothing of them",
     "{1} di {2} elementi esposti sono fuori dalla mappa o su terreno senza quota, il primo è {3}: il risultato non ne "
     "dirà nulla",
     "{1} von {2} exponierten Objekten liegen außerhalb der Karte oder auf Gelände ohne Höhe, das erste ist {3}: das "
     "Ergebnis sagt nichts über sie",
     "{1} éléments exposés sur {2} sont hors de la carte ou sur un terrain sans altitude, le premier est {3}\u202F: le "
     "résultat n’en dira rien",
     "{1} de {2} elementos expuestos están fuera del mapa o en terreno sin cota, el primero es {3}: el resultado no "
     "dirá "
     "nada de ellos"},
    {"the thickness raster contains {1} m3, of which the perimeter has {2} m3: {3} % lie beyond it and are not "
     "released. "
     "Draw the perimeter around all of the raster's mass, or leave release.perimeter out",
     "il raster dello spessore contiene {1} m³, di cui {2} m³ entro il perimetro: il {3} % sta fuori e non si "
     "distacca. "
     "Tracciare il perimetro attorno a tutta la massa del raster, oppure omettere release.perimeter",
     "das Mächtigkeitsraster enthält {1} m³, davon {2} m³ innerhalb des Umrisses: {3} % liegen außerhalb und werden "
     "nicht freigesetzt. Den Umriss um die ganze Masse des Rasters ziehen oder release.perimeter weglassen",
     "le raster d’épaisseur contient {1} m³, dont {2} m³ dans le périmètre\u202F: {3}\u202F% sont au-dehors et ne "
     "partent pas. Tracer le périmètre autour de toute la masse du raster, ou omettre release.perimeter",
     "el ráster de espesor contiene {1} m³, de los que {2} m³ están dentro del perímetro: el {3} % queda fuera y no se "
     "libera. Trazar el perímetro alrededor de toda la masa del ráster u omitir release.perimeter"},
    {"the thickness raster contains {1} m3 inside the perimeter; the release has {2} m3",
     "il raster dello spessore contiene {1} m³ entro il perimetro; il distacco ha {2} m³",
     "das Mächtigkeitsraster enthält {1} m³ innerhalb des Umrisses; der Anriss hat {2} m³",
     "le raster d’épaisseur contient {1} m³ dans le périmètre\u202F; le départ a {2} m³",
     "el ráster de espesor contiene {1} m³ dentro del perímetro; lo liberado tiene {2} m³"},
    {"{1} % of the release is thinner than {2} = {3} m: {4}", "il {1} % del distacco è più sottile di {2} = {3} m: {4}",
     "{1} % des Anrisses sind dünner als {2} = {3} m: {4}",
     "{1}\u202F% du départ est plus mince que {2} = {3} m\u202F: {4}",
     "el {1} % de lo liberado es más delgado que {2} = {3} m: {4}"},
    {"maps and results do not include it; set the key to about a hundredth of the usual flow depth",
     "mappe e risultati non lo comprendono; impostare la chiave a circa un centesimo della profondità usuale del "
     "flusso",
     "Karten und Ergebnisse enthalten ihn nicht; den Schlüssel auf etwa ein Hundertstel der üblichen Fließtiefe setzen",
     "cartes et résultats ne le comprennent pas\u202F; fixer la clé à environ un centième de la hauteur usuelle de "
     "l’écoulement",
     "mapas y resultados no lo incluyen; fije la clave en alrededor de una centésima de la profundidad usual del "
     "flujo"},
    {"outlines, covered area and run-out do not include it; set the key to about a tenth of the usual flow depth",
     "perimetri, area coperta e distanza di propagazione non lo comprendono; impostare la chiave a circa un decimo "
     "della "
     "profondità usuale del flusso",
     "Umrisse, bedeckte Fläche und Auslauflänge enthalten ihn nicht; den Schlüssel auf etwa ein Zehntel der üblichen "
     "Fließtiefe setzen",
     "contours, surface couverte et distance de propagation ne le comprennent pas\u202F; fixer la clé à environ un "
     "dixième "
     "de la hauteur usuelle de l’écoulement",
     "contornos, área cubierta y alcance no lo incluyen; fije la clave en alrededor de una décima de la profundidad "
     "usual del flujo"},
    // Zones and obstacles: src/app/input/prepare_zones.cpp, prepare_obstacles.cpp.
    {"{1} m2, {2} % of the working grid", "{1} m², {2} % della griglia di lavoro", "{1} m², {2} % des Arbeitsgitters",
     "{1} m², {2}\u202F% de la grille de travail", "{1} m², {2} % de la malla de trabajo"},
    {"zones overlap on {1}: the later feature of the layer applies there",
     "le zone si sovrappongono su {1}: lì vale l’elemento successivo dello strato",
     "Zonen überlappen sich auf {1}: dort gilt das spätere Objekt der Ebene",
     "des zones se recouvrent sur {1}\u202F: l’entité la plus tardive de la couche s’y applique",
     "hay zonas superpuestas en {1}: ahí vale el elemento posterior de la capa"},
    {"there are gaps between the zones on {1}: the material's own values apply there",
     "ci sono vuoti fra le zone su {1}: lì valgono i valori del materiale",
     "zwischen den Zonen gibt es Lücken auf {1}: dort gelten die Werte des Materials",
     "il y a des vides entre les zones sur {1}\u202F: les valeurs du matériau s’y appliquent",
     "hay huecos entre las zonas en {1}: ahí valen los valores del material"},
    {"{1} has no value on {2}: {3}", "{1} non ha valore su {2}: {3}", "{1} hat keinen Wert auf {2}: {3}",
     "{1} n’a pas de valeur sur {2}\u202F: {3}", "{1} no tiene valor en {2}: {3}"},
    {"the material's own value applies there", "lì vale il valore del materiale", "dort gilt der Wert des Materials",
     "la valeur du matériau s’y applique", "ahí vale el valor del material"},
    {"{1}: feature {2} of {3} is narrower than the cells: it covers {4} m2 of the working grid, the drawn area is {5} "
     "m2; choose smaller cells",
     "{1}: l’elemento {2} di {3} è più stretto delle celle: copre {4} m² della griglia di lavoro, l’area disegnata è "
     "{5} m²; scegliere celle più piccole",
     "{1}: Objekt {2} von {3} ist schmaler als die Zellen: es bedeckt {4} m² des Arbeitsgitters, die gezeichnete "
     "Fläche misst {5} m²; kleinere Zellen wählen",
     "{1}\u202F: l’entité {2} de {3} est plus étroite que les mailles\u202F: elle couvre {4} m² de la grille de "
     "travail, la surface dessinée est de {5} m²\u202F; choisir des mailles plus petites",
     "{1}: el elemento {2} de {3} es más estrecho que las celdas: cubre {4} m² de la malla de trabajo, el área "
     "dibujada es de {5} m²; elija celdas más pequeñas"},
    // Structured model: src/app/input/check_structured.cpp.
    {"{1} has no effect: structured.fluid-viscosity is 0", "{1} non ha effetto: structured.fluid-viscosity è 0",
     "{1} hat keine Wirkung: structured.fluid-viscosity ist 0",
     "{1} est sans effet\u202F: structured.fluid-viscosity vaut 0",
     "{1} no tiene efecto: structured.fluid-viscosity es 0"},
    {"{1} has no effect: without structured.cohesion nothing confines fluid, and all of it is free",
     "{1} non ha effetto: senza structured.cohesion nulla confina il fluido, che è tutto libero",
     "{1} hat keine Wirkung: ohne structured.cohesion schließt nichts das Fluid ein, und alles davon ist frei",
     "{1} est sans effet\u202F: sans structured.cohesion rien ne confine le fluide, qui est entièrement libre",
     "{1} no tiene efecto: sin structured.cohesion nada confina el fluido, y todo él es libre"},
    {"{1} has no effect: with structured.solid-fraction = 1 there are no pores",
     "{1} non ha effetto: con structured.solid-fraction = 1 non ci sono pori",
     "{1} hat keine Wirkung: mit structured.solid-fraction = 1 gibt es keine Poren",
     "{1} est sans effet\u202F: avec structured.solid-fraction = 1 il n’y a pas de pores",
     "{1} no tiene efecto: con structured.solid-fraction = 1 no hay poros"},
    {"structured.bed-friction-angle is up to {1} degrees more than the material's internal-friction-angle: it would "
     "shear within itself and leave a layer on the bed, which the model does not compute. Take at most the internal "
     "angle",
     "structured.bed-friction-angle supera fino a {1} gradi l’internal-friction-angle del materiale: questo si "
     "taglierebbe al proprio interno e lascerebbe uno strato sul fondo, cosa che il modello non calcola. Usare al "
     "massimo l’angolo interno",
     "structured.bed-friction-angle ist bis zu {1} Grad größer als der internal-friction-angle des Materials: es würde "
     "in sich selbst scheren und eine Schicht auf der Sohle lassen, was das Modell nicht rechnet. Höchstens den "
     "inneren Winkel nehmen",
     "structured.bed-friction-angle dépasse de {1} degrés au plus l’internal-friction-angle du matériau\u202F: "
     "celui-ci se cisaillerait en lui-même et laisserait une couche sur le lit, ce que le modèle ne calcule pas. "
     "Prendre au plus l’angle interne",
     "structured.bed-friction-angle supera hasta en {1} grados el internal-friction-angle del material: este se "
     "cizallaría en sí mismo y dejaría una capa en el lecho, lo que el modelo no calcula. Tome como máximo el ángulo "
     "interno"},
    {"at its strength the material has an elastic strain of {1}, more than structured.critical-strain = {2}: it loses "
     "its cohesion before it yields. Raise structured.young-modulus (and bulk-modulus) or the critical strain, or "
     "lower the cohesion",
     "alla resistenza il materiale ha una deformazione elastica di {1}, più di structured.critical-strain = {2}: perde "
     "la coesione prima di cedere. Aumentare structured.young-modulus (e bulk-modulus) o la deformazione critica, o "
     "ridurre la coesione",
     "an seiner Festigkeit hat das Material eine elastische Dehnung von {1}, mehr als structured.critical-strain = "
     "{2}: es verliert seine Kohäsion, bevor es fließt. structured.young-modulus (und bulk-modulus) oder die kritische "
     "Dehnung erhöhen, oder die Kohäsion senken",
     "à sa résistance le matériau a une déformation élastique de {1}, plus que structured.critical-strain = {2}\u202F: "
     "il perd sa cohésion avant de céder. Augmenter structured.young-modulus (et bulk-modulus) ou la déformation "
     "critique, ou réduire la cohésion",
     "en su resistencia el material tiene una deformación elástica de {1}, más que structured.critical-strain = {2}: "
     "pierde su cohesión antes de ceder. Aumente structured.young-modulus (y bulk-modulus) o la deformación crítica, o "
     "reduzca la cohesión"},
    {"the release is at most {1} m thick, less than 1.53 tan({2} degrees) times the cell size, {3} m: its edges stand "
     "whatever their cohesion, and it breaks too little. Choose terrain.cell-size = {4} or less",
     "il distacco è spesso al massimo {1} m, meno di 1,53 tan({2} gradi) volte la cella, {3} m: i suoi bordi reggono "
     "qualunque sia la coesione, e si rompe troppo poco. Scegliere terrain.cell-size = {4} o meno",
     "der Anriss ist höchstens {1} m mächtig, weniger als 1,53 tan({2} Grad) mal die Zellgröße, {3} m: seine Ränder "
     "stehen bei jeder Kohäsion, und er bricht zu wenig. terrain.cell-size = {4} oder weniger wählen",
     "le départ a au plus {1} m d’épaisseur, moins que 1,53 tan({2} degrés) fois la maille, {3} m\u202F: ses bords "
     "tiennent quelle que soit leur cohésion, et il se rompt trop peu. Choisir terrain.cell-size = {4} ou moins",
     "lo liberado tiene como máximo {1} m de espesor, menos que 1,53 tan({2} grados) veces la celda, {3} m: sus bordes "
     "se sostienen con cualquier cohesión, y se rompe demasiado poco. Elija terrain.cell-size = {4} o menos"},
    // Files: gis.
    {"{1}: its values are in \"{2}\", which is not a unit of length; used without conversion",
     "{1}: i valori sono in \"{2}\", che non è un’unità di lunghezza; usati senza conversione",
     "{1}: die Werte sind in \"{2}\", was keine Längeneinheit ist; ohne Umrechnung benutzt",
     "{1}\u202F: ses valeurs sont en \"{2}\", qui n’est pas une unité de longueur\u202F; utilisées sans conversion",
     "{1}: sus valores están en \"{2}\", que no es una unidad de longitud; se usan sin conversión"},
    {"{1}: eastings and northings are not in metres and the file does not state the unit of its values; they were "
     "taken as metres. If they are feet, set the vertical unit",
     "{1}: le coordinate non sono in metri e il file non indica l’unità dei valori; sono stati presi come metri. Se "
     "sono piedi, impostare l’unità verticale",
     "{1}: Rechts- und Hochwerte sind nicht in Metern, und die Datei nennt die Einheit ihrer Werte nicht; sie wurden "
     "als Meter genommen. Sind es Fuß, die vertikale Einheit setzen",
     "{1}\u202F: les coordonnées ne sont pas en mètres et le fichier n’indique pas l’unité de ses valeurs\u202F; elles "
     "ont été prises pour des mètres. Si ce sont des pieds, fixer l’unité verticale",
     "{1}: las coordenadas no están en metros y el archivo no indica la unidad de sus valores; se tomaron como metros. "
     "Si son pies, fije la unidad vertical"},
    {"{1}: {2} cells have the value {3}, which the file does not declare as nodata; they were read as values. If they "
     "are nodata, declare it: gdal_edit.py -a_nodata {3} FILE",
     "{1}: {2} celle hanno il valore {3}, che il file non dichiara come assenza di dato; sono state lette come valori. "
     "Se sono senza dato, dichiararlo: gdal_edit.py -a_nodata {3} FILE",
     "{1}: {2} Zellen haben den Wert {3}, den die Datei nicht als Fehlwert erklärt; sie wurden als Werte gelesen. "
     "Fehlwerte sind zu erklären: gdal_edit.py -a_nodata {3} DATEI",
     "{1}\u202F: {2} mailles ont la valeur {3}, que le fichier ne déclare pas comme absence de donnée\u202F; elles ont "
     "été lues comme des valeurs. Si elles sont sans donnée, le déclarer\u202F: gdal_edit.py -a_nodata {3} FICHIER",
     "{1}: {2} celdas tienen el valor {3}, que el archivo no declara como sin dato; se leyeron como valores. Si no "
     "tienen dato, declárelo: gdal_edit.py -a_nodata {3} ARCHIVO"},
    {"the outline was repaired ({1}): area {2} before, {3} after, in its own units squared",
     "il perimetro è stato riparato ({1}): area {2} prima, {3} dopo, nelle sue unità al quadrato",
     "der Umriss wurde ausgebessert ({1}): Fläche {2} vorher, {3} nachher, in eigenen Einheiten zum Quadrat",
     "le contour a été réparé ({1})\u202F: surface {2} avant, {3} après, dans ses unités au carré",
     "el contorno se reparó ({1}): área {2} antes, {3} después, en sus unidades al cuadrado"},
    {"parts overlap or touch and were united ({1}): area {2} before, {3} after, in its own units squared",
     "parti sovrapposte o a contatto sono state unite ({1}): area {2} prima, {3} dopo, nelle sue unità al quadrato",
     "Teile überlappen oder berühren sich und wurden vereinigt ({1}): Fläche {2} vorher, {3} nachher, in eigenen "
     "Einheiten zum Quadrat",
     "des parties se recouvrent ou se touchent et ont été réunies ({1})\u202F: surface {2} avant, {3} après, dans ses "
     "unités au carré",
     "partes que se superponen o se tocan se unieron ({1}): área {2} antes, {3} después, en sus unidades al cuadrado"},
    {"{1}: feature {2} has no geometry and was left out", "{1}: l’elemento {2} non ha geometria ed è stato omesso",
     "{1}: Objekt {2} hat keine Geometrie und wurde weggelassen",
     "{1}\u202F: l’entité {2} n’a pas de géométrie et a été omise",
     "{1}: el elemento {2} no tiene geometría y se omitió"},
    {"{1}: feature {2} is a closed line and was taken as an area",
     "{1}: l’elemento {2} è una linea chiusa ed è stato preso come area",
     "{1}: Objekt {2} ist eine geschlossene Linie und wurde als Fläche genommen",
     "{1}\u202F: l’entité {2} est une ligne fermée et a été prise comme surface",
     "{1}: el elemento {2} es una línea cerrada y se tomó como área"},
    {"{1}: feature {2}: {3}", "{1}: elemento {2}: {3}", "{1}: Objekt {2}: {3}", "{1}\u202F: entité {2}\u202F: {3}",
     "{1}: elemento {2}: {3}"},
    {"{1}: areas {2} and {3} overlap by {4} square units",
     "{1}: le aree {2} e {3} si sovrappongono per {4} unità quadrate",
     "{1}: die Flächen {2} und {3} überlappen sich um {4} Quadrateinheiten",
     "{1}\u202F: les surfaces {2} et {3} se recouvrent de {4} unités carrées",
     "{1}: las áreas {2} y {3} se superponen en {4} unidades cuadradas"},
    {"{1} (further pairs were not checked)", "{1} (altre coppie non sono state controllate)",
     "{1} (weitere Paare wurden nicht geprüft)", "{1} (les autres paires n’ont pas été vérifiées)",
     "{1} (no se comprobaron más pares)"},
});

}  // namespace

std::span<const WordRow> input_warning_words() {
    return k_input_warning_words;
}

}  // namespace frana
