// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_result_warning_words = std::to_array<WordRow>({
    // Of a run: src/app/publish/publish.cpp.
    {"release area {1}", "area di distacco {1}", "Anrissfläche {1}", "zone de départ {1}", "área de inicio {1}"},
    {"release area {1} '{2}'", "area di distacco {1} “{2}”", "Anrissfläche {1} „{2}“", "zone de départ {1} « {2} »",
     "área de inicio {1} «{2}»"},
    {"{1}: {2} m3 from {3} m2", "{1}: {2} m³ da {3} m²", "{1}: {2} m³ aus {3} m²", "{1}\u202F: {2} m³ de {3} m²",
     "{1}: {2} m³ de {3} m²"},
    {"{1}: {2} m3 from {3} m2, at {4} s", "{1}: {2} m³ da {3} m², a {4} s", "{1}: {2} m³ aus {3} m², bei {4} s",
     "{1}\u202F: {2} m³ de {3} m², à {4} s", "{1}: {2} m³ de {3} m², a los {4} s"},
    {"{1}: not before the end of the run", "{1}: non prima della fine del calcolo",
     "{1}: nicht vor dem Ende der Rechnung", "{1}\u202F: pas avant la fin du calcul",
     "{1}: no antes del fin del cálculo"},
    {"{1} % of the volume changed cell", "il {1} % del volume ha cambiato cella",
     "{1} % des Volumens wechselten die Zelle", "{1}\u202F% du volume a changé de maille",
     "el {1} % del volumen cambió de celda"},
    {"all of the volume changed cell, {1} times over", "tutto il volume ha cambiato cella, {1} volte",
     "das ganze Volumen wechselte die Zelle, {1}-mal", "tout le volume a changé de maille, {1} fois",
     "todo el volumen cambió de celda, {1} veces"},
    {"the flow still moves when time.end is reached: {1} % of its volume faster than {2} m/s",
     "il flusso si muove ancora quando si raggiunge time.end: il {1} % del volume oltre {2} m/s",
     "der Strom bewegt sich noch, wenn time.end erreicht ist: {1} % seines Volumens schneller als {2} m/s",
     "l’écoulement bouge encore quand time.end est atteint\u202F: {1}\u202F% de son volume à plus de {2} m/s",
     "el flujo aún se mueve al alcanzar time.end: el {1} % de su volumen a más de {2} m/s"},
    {"{1}, the fastest at {2} m/s", "{1}, il più veloce a {2} m/s", "{1}, das schnellste mit {2} m/s",
     "{1}, le plus rapide à {2} m/s", "{1}, lo más rápido a {2} m/s"},
    {"{1}; in its last {2} s the run-out grew by {3} m, the area by {4} % and {5}",
     "{1}; negli ultimi {2} s la distanza di propagazione è cresciuta di {3} m, l’area del {4} % e {5}",
     "{1}; in den letzten {2} s wuchs die Auslauflänge um {3} m, die Fläche um {4} %, und {5}",
     "{1}\u202F; dans ses dernières {2} s la distance de propagation a augmenté de {3} m, la surface de {4}\u202F% et "
     "{5}",
     "{1}; en sus últimos {2} s el alcance creció {3} m, el área un {4} % y {5}"},
    {"{1}. Final depth and run-out are not those of the deposit: raise time.end",
     "{1}. Profondità finale e distanza di propagazione non sono quelle del deposito: aumentare time.end",
     "{1}. Endtiefe und Auslauflänge sind nicht die der Ablagerung: time.end erhöhen",
     "{1}. Hauteur finale et distance de propagation ne sont pas celles du dépôt\u202F: augmenter time.end",
     "{1}. La profundidad final y el alcance no son los del depósito: aumente time.end"},
    {"at one time {1} % of the flow was thinner than numerics.minimum-depth = {2} m, and is not included there in "
     "maps, areas, speeds and run-out: set numerics.minimum-depth to about a hundredth of the usual flow depth",
     "a un certo momento il {1} % del flusso era più sottile di numerics.minimum-depth = {2} m, e lì non è compreso in "
     "mappe, aree, velocità e distanza di propagazione: impostare numerics.minimum-depth a circa un centesimo della "
     "profondità usuale del flusso",
     "zeitweise waren {1} % des Stroms dünner als numerics.minimum-depth = {2} m und sind dort nicht in Karten, "
     "Flächen, Geschwindigkeiten und Auslauflänge enthalten: numerics.minimum-depth auf etwa ein Hundertstel der "
     "üblichen Fließtiefe setzen",
     "à un moment {1}\u202F% de l’écoulement était plus mince que numerics.minimum-depth = {2} m, et n’y est pas "
     "compris dans cartes, surfaces, vitesses et distance de propagation\u202F: fixer numerics.minimum-depth à environ "
     "un "
     "centième de la hauteur usuelle de l’écoulement",
     "en algún momento el {1} % del flujo fue más delgado que numerics.minimum-depth = {2} m, y ahí no está incluido "
     "en mapas, áreas, velocidades y alcance: fije numerics.minimum-depth en alrededor de una centésima de la "
     "profundidad usual del flujo"},
    {"the maps are empty: the flow was nowhere as deep as numerics.minimum-depth = {2} m, and is not included there in "
     "maps, areas, speeds and run-out: set numerics.minimum-depth to about a hundredth of the usual flow depth",
     "le mappe sono vuote: il flusso non ha mai raggiunto numerics.minimum-depth = {2} m, e non è compreso in mappe, "
     "aree, velocità e distanza di propagazione: impostare numerics.minimum-depth a circa un centesimo della "
     "profondità "
     "usuale del flusso",
     "die Karten sind leer: der Strom war nirgends so tief wie numerics.minimum-depth = {2} m und ist nicht in Karten, "
     "Flächen, Geschwindigkeiten und Auslauflänge enthalten: numerics.minimum-depth auf etwa ein Hundertstel der "
     "üblichen Fließtiefe setzen",
     "les cartes sont vides\u202F: l’écoulement n’a nulle part atteint numerics.minimum-depth = {2} m, et n’est pas "
     "compris dans cartes, surfaces, vitesses et distance de propagation\u202F: fixer numerics.minimum-depth à environ "
     "un "
     "centième de la hauteur usuelle de l’écoulement",
     "los mapas están vacíos: el flujo no alcanzó en ningún lugar numerics.minimum-depth = {2} m, y no está incluido "
     "en mapas, áreas, velocidades y alcance: fije numerics.minimum-depth en alrededor de una centésima de la "
     "profundidad usual del flujo"},
    {"the flow was nowhere deeper than output.trace-threshold = {1} m, but {2} m: trace, deposit and covered area are "
     "empty, run-out is 0 and a comparison finds nothing. Set output.trace-threshold to about a tenth of the usual "
     "flow depth",
     "il flusso non è stato in nessun punto più profondo di output.trace-threshold = {1} m, ma {2} m: traccia, "
     "deposito e area coperta sono vuoti, la distanza di propagazione è 0 e un confronto non trova nulla. Impostare "
     "output.trace-threshold a circa un decimo della profondità usuale del flusso",
     "der Strom war nirgends tiefer als output.trace-threshold = {1} m, sondern {2} m: Spur, Ablagerung und bedeckte "
     "Fläche sind leer, die Auslauflänge ist 0, und ein Vergleich findet nichts. output.trace-threshold auf etwa ein "
     "Zehntel der üblichen Fließtiefe setzen",
     "l’écoulement n’a nulle part dépassé output.trace-threshold = {1} m, mais {2} m\u202F: trace, dépôt et surface "
     "couverte sont vides, la distance de propagation est 0 et une comparaison ne trouve rien. Fixer "
     "output.trace-threshold "
     "à environ un dixième de la hauteur usuelle de l’écoulement",
     "el flujo no fue en ningún lugar más profundo que output.trace-threshold = {1} m, sino {2} m: traza, depósito y "
     "área cubierta están vacíos, el alcance es 0 y una comparación no encuentra nada. Fije output.trace-threshold en "
     "alrededor de una décima de la profundidad usual del flujo"},
    {"the run ended because the flow reached ground without elevation: the map is incomplete; use a larger DTM, or set "
     "terrain.nodata-policy to wall or fill",
     "il calcolo è finito perché il flusso ha raggiunto terreno senza quota: la mappa è incompleta; usare un DTM più "
     "grande, o impostare terrain.nodata-policy a wall o fill",
     "die Rechnung endete, weil der Strom Gelände ohne Höhe erreichte: die Karte ist unvollständig; ein größeres DGM "
     "nehmen, oder terrain.nodata-policy auf wall oder fill setzen",
     "le calcul s’est terminé parce que l’écoulement a atteint un terrain sans altitude\u202F: la carte est "
     "incomplète\u202F; utiliser un MNT plus grand, ou fixer terrain.nodata-policy à wall ou fill",
     "el cálculo terminó porque el flujo alcanzó terreno sin cota: el mapa está incompleto; use un MDT mayor, o fije "
     "terrain.nodata-policy en wall o fill"},
    {"the computation had numerical events that do not occur in a good run; see hard_events in summary.json",
     "il calcolo ha avuto eventi numerici che non si verificano in un buon calcolo; vedi hard_events in summary.json",
     "die Rechnung hatte numerische Ereignisse, die in einer guten Rechnung nicht vorkommen; siehe hard_events in "
     "summary.json",
     "le calcul a eu des événements numériques qui n’arrivent pas dans un bon calcul\u202F; voir hard_events dans "
     "summary.json",
     "el cálculo tuvo eventos numéricos que no ocurren en un buen cálculo; véase hard_events en summary.json"},
    {"the depths of final_depth.tif add up to {1} m3, the flow has {2} m3: where particles are crowded, in gullies "
     "narrower than a few cells, the depths shown are too small. Choose smaller cells, or take deposit volumes from "
     "summary.json",
     "le profondità di final_depth.tif sommano a {1} m³, il flusso ha {2} m³: dove le particelle sono fitte, in canali "
     "più stretti di poche celle, le profondità mostrate sono troppo piccole. Scegliere celle più piccole, o prendere "
     "i volumi del deposito da summary.json",
     "die Tiefen von final_depth.tif ergeben {1} m³, der Strom hat {2} m³: wo die Partikel dicht liegen, in Rinnen "
     "schmaler als einige Zellen, sind die gezeigten Tiefen zu klein. Kleinere Zellen wählen, oder Ablagerungsvolumen "
     "aus summary.json nehmen",
     "les hauteurs de final_depth.tif font {1} m³, l’écoulement a {2} m³\u202F: là où les particules sont serrées, "
     "dans des ravines plus étroites que quelques mailles, les hauteurs montrées sont trop petites. Choisir des "
     "mailles plus petites, ou prendre les volumes du dépôt dans summary.json",
     "las profundidades de final_depth.tif suman {1} m³, el flujo tiene {2} m³: donde las partículas están apretadas, "
     "en cauces más estrechos que unas pocas celdas, las profundidades mostradas son demasiado pequeñas. Elija celdas "
     "más pequeñas, o tome los volúmenes del depósito de summary.json"},
    {"{1} m3 left the computed ground ({2} % of all volume that came in): the map does not show its full run-out; use "
     "a larger DTM or terrain.bounds",
     "{1} m³ hanno lasciato il terreno calcolato (il {2} % di tutto il volume entrato): la mappa non ne mostra "
     "l’intera propagazione; usare un DTM o terrain.bounds più grandi",
     "{1} m³ verließen das berechnete Gelände ({2} % des gesamten zugeführten Volumens): die Karte zeigt nicht ihren "
     "ganzen Auslauf; ein größeres DGM oder terrain.bounds nehmen",
     "{1} m³ sont sortis du terrain calculé ({2}\u202F% de tout le volume entré)\u202F: la carte n’en montre pas toute "
     "la propagation\u202F; utiliser un MNT ou un terrain.bounds plus grand",
     "{1} m³ salieron del terreno calculado (el {2} % de todo el volumen que entró): el mapa no muestra todo su "
     "alcance; use un MDT o terrain.bounds mayores"},
    {"the survey could not be compared: {1}", "il rilievo non ha potuto essere confrontato: {1}",
     "die Kartierung konnte nicht verglichen werden: {1}", "le levé n’a pas pu être comparé\u202F: {1}",
     "el levantamiento no pudo compararse: {1}"},
    // Pictures.
    {"{1} could not be drawn: {2}", "{1} non ha potuto essere disegnato: {2}",
     "{1} konnte nicht gezeichnet werden: {2}", "{1} n’a pas pu être dessiné\u202F: {2}", "{1} no pudo dibujarse: {2}"},
    {"output.map-scale = {1} does not hold the flow; drawn at {2}",
     "output.map-scale = {1} non contiene il flusso; disegnato a {2}",
     "output.map-scale = {1} fasst den Strom nicht; gezeichnet in {2}",
     "output.map-scale = {1} ne contient pas l’écoulement\u202F; dessiné au {2}",
     "output.map-scale = {1} no abarca el flujo; dibujado a {2}"},
    {"{1} is left out because of the signal", "{1} è omesso a causa del segnale", "{1} fehlt wegen des Signals",
     "{1} est omis à cause du signal", "{1} se omite a causa de la señal"},
    {"left out because of the signal: {1}; the same command with --resume draws them",
     "omessi a causa del segnale: {1}; lo stesso comando con --resume li disegna",
     "wegen des Signals weggelassen: {1}; derselbe Befehl mit --resume zeichnet sie",
     "omis à cause du signal\u202F: {1}\u202F; la même commande avec --resume les dessine",
     "omitidos a causa de la señal: {1}; la misma orden con --resume los dibuja"},
    {"no installed font has the letters {1}: pictures show boxes in their place. Install a font that has them, for "
     "example Debian's fonts-noto-core or fonts-noto-cjk, and draw again with frana render",
     "nessun carattere installato ha le lettere {1}: le immagini mostrano riquadri al loro posto. Installare un "
     "carattere che le abbia, per esempio fonts-noto-core o fonts-noto-cjk di Debian, e ridisegnare con frana render",
     "keine installierte Schrift hat die Zeichen {1}: Bilder zeigen an ihrer Stelle Kästchen. Eine Schrift "
     "installieren, die sie hat, zum Beispiel fonts-noto-core oder fonts-noto-cjk von Debian, und mit frana render neu "
     "zeichnen",
     "aucune police installée n’a les caractères {1}\u202F: les images montrent des cases à leur place. Installer une "
     "police qui les a, par exemple fonts-noto-core ou fonts-noto-cjk de Debian, et redessiner avec frana render",
     "ninguna fuente instalada tiene los caracteres {1}: las imágenes muestran recuadros en su lugar. Instale una "
     "fuente que los tenga, por ejemplo fonts-noto-core o fonts-noto-cjk de Debian, y dibuje de nuevo con frana "
     "render"},
    {"the AvaFrame rasters are written as GeoTIFF: an ASCII grid would hold all {1} cells of the map, reached or not",
     "i raster di AvaFrame sono scritti come GeoTIFF: una griglia ASCII conterrebbe tutte le {1} celle della mappa, "
     "raggiunte o no",
     "die AvaFrame-Raster werden als GeoTIFF geschrieben: ein ASCII-Gitter enthielte alle {1} Zellen der Karte, "
     "erreicht oder nicht",
     "les rasters d’AvaFrame sont écrits en GeoTIFF\u202F: une grille ASCII contiendrait les {1} mailles de la carte, "
     "atteintes ou non",
     "los rásteres de AvaFrame se escriben como GeoTIFF: una malla ASCII contendría las {1} celdas del mapa, "
     "alcanzadas o no"},
    // Comparisons.
    {"the raster has no CRS: the survey's coordinates are used without transformation",
     "il raster non ha SR: le coordinate del rilievo sono usate senza trasformazione",
     "das Raster hat kein KBS: die Koordinaten der Kartierung werden ohne Transformation benutzt",
     "le raster n’a pas de SCR\u202F: les coordonnées du levé sont utilisées sans transformation",
     "el ráster no tiene SRC: las coordenadas del levantamiento se usan sin transformación"},
    {"fronts and tips are not compared with a map of probability",
     "fronti e punte non si confrontano con una mappa di probabilità",
     "Fronten und Spitzen werden nicht mit einer Wahrscheinlichkeitskarte verglichen",
     "fronts et pointes ne sont pas comparés à une carte de probabilité",
     "frentes y puntas no se comparan con un mapa de probabilidad"},
    {"the surveyed outline reaches beyond the map; there its probability counts as 0",
     "il perimetro osservato va oltre la mappa; lì la probabilità vale 0",
     "der beobachtete Umriss reicht über die Karte hinaus; dort zählt die Wahrscheinlichkeit als 0",
     "le contour observé dépasse la carte\u202F; la probabilité y compte pour 0",
     "el contorno observado sobrepasa el mapa; ahí su probabilidad cuenta como 0"},
    {"the surveyed outline reaches beyond the result's rasters, so its run-out is unknown: no run-out difference. With "
     "output.extent = map a run's rasters cover the whole map",
     "il perimetro osservato va oltre i raster del risultato, quindi la sua distanza di propagazione è ignota: nessuna "
     "differenza. Con output.extent = map i raster di un calcolo coprono l’intera mappa",
     "der beobachtete Umriss reicht über die Raster des Ergebnisses hinaus, daher ist seine Auslauflänge unbekannt: "
     "kein Unterschied der Auslauflängen. Mit output.extent = map decken die Raster einer Rechnung die ganze Karte ab",
     "le contour observé dépasse les rasters du résultat, sa distance de propagation est donc inconnue\u202F: pas de "
     "différence. Avec output.extent = map les rasters d’un calcul couvrent toute la carte",
     "el contorno observado sobrepasa los rásteres del resultado, así que su alcance se desconoce: no hay diferencia "
     "de alcance. Con output.extent = map los rásteres de un cálculo cubren todo el mapa"},
    {"nothing is deeper than {1} m, so there is no front to compare",
     "nulla è più profondo di {1} m, quindi non c’è un fronte da confrontare",
     "nichts ist tiefer als {1} m, daher gibt es keine Front zu vergleichen",
     "rien n’est plus profond que {1} m, il n’y a donc pas de front à comparer",
     "nada es más profundo que {1} m, así que no hay frente que comparar"},
    {"there is no depth at the end to compare with the surveyed deposit",
     "non c’è una profondità finale da confrontare con il deposito rilevato",
     "es gibt keine Endtiefe, die mit der kartierten Ablagerung zu vergleichen wäre",
     "il n’y a pas de hauteur finale à comparer au dépôt levé",
     "no hay profundidad final que comparar con el depósito levantado"},
    {"the surveyed outline reaches beyond the result's rasters; its part outside counts as missed",
     "il perimetro osservato va oltre i raster del risultato; la parte fuori conta come mancata",
     "der beobachtete Umriss reicht über die Raster des Ergebnisses hinaus; sein Teil außerhalb zählt als verfehlt",
     "le contour observé dépasse les rasters du résultat\u202F; sa partie extérieure compte comme manquée",
     "el contorno observado sobrepasa los rásteres del resultado; su parte exterior cuenta como no acertada"},
    {"report.html is of an older frana and stays without this comparison; run the scene again",
     "report.html è di una frana precedente e resta senza questo confronto; rifare il calcolo della scena",
     "report.html stammt von einer älteren frana und bleibt ohne diesen Vergleich; die Szene neu rechnen",
     "report.html vient d’une frana plus ancienne et reste sans cette comparaison\u202F; recalculer la scène",
     "report.html es de una frana anterior y queda sin esta comparación; vuelva a calcular la escena"},
    // Many runs.
    {"{1} of {2} members failed and are in no map; the first, member {3}: {4}. members.csv has the reason of each",
     "{1} simulazioni su {2} sono fallite e non sono in alcuna mappa; la prima, la {3}: {4}. members.csv ha il motivo "
     "di ciascuna",
     "{1} von {2} Läufen scheiterten und sind in keiner Karte; der erste, Lauf {3}: {4}. members.csv nennt den Grund "
     "jedes Laufs",
     "{1} calculs sur {2} ont échoué et ne sont dans aucune carte\u202F; le premier, le calcul {3}\u202F: {4}. "
     "members.csv donne la raison de chacun",
     "{1} de {2} simulaciones fallaron y no están en ningún mapa; la primera, la {3}: {4}. members.csv da la razón de "
     "cada una"},
    {"study.until = {1} is not reached with all members: raise study.samples",
     "study.until = {1} non è raggiunto con tutte le simulazioni: aumentare study.samples",
     "study.until = {1} wird mit allen Läufen nicht erreicht: study.samples erhöhen",
     "study.until = {1} n’est pas atteint avec tous les calculs\u202F: augmenter study.samples",
     "study.until = {1} no se alcanza con todas las simulaciones: aumente study.samples"},
    {"{1} of {2} runs failed: their members have no weight. posterior.csv has the reason of each",
     "{1} calcoli su {2} sono falliti: le loro simulazioni non hanno peso. posterior.csv ha il motivo di ciascuno",
     "{1} von {2} Rechnungen scheiterten: ihre Läufe haben kein Gewicht. posterior.csv nennt den Grund jeder einzelnen",
     "{1} calculs sur {2} ont échoué\u202F: leurs membres n’ont pas de poids. posterior.csv donne la raison de chacun",
     "{1} de {2} cálculos fallaron: sus simulaciones no tienen peso. posterior.csv da la razón de cada uno"},
    // Files and sessions.
    {"{1}: {2} is not as it was when this result was computed (then {3}; now {4}): the run repeats the scene, not the "
     "result",
     "{1}: {2} non è come quando questo risultato è stato calcolato (allora {3}; ora {4}): il calcolo ripete la scena, "
     "non il risultato",
     "{1}: {2} ist nicht, wie es war, als dieses Ergebnis berechnet wurde (damals {3}; jetzt {4}): die Rechnung "
     "wiederholt die Szene, nicht das Ergebnis",
     "{1}\u202F: {2} n’est pas tel qu’il était quand ce résultat a été calculé (alors {3}\u202F; maintenant "
     "{4})\u202F: le calcul répète la scène, non le résultat",
     "{1}: {2} no es como era cuando se calculó este resultado (entonces {3}; ahora {4}): el cálculo repite la escena, "
     "no el resultado"},
    {"the older result could not be removed: {1}; what is left of it is in {2} until the next run",
     "il risultato precedente non ha potuto essere rimosso: {1}; quanto ne resta è in {2} fino al prossimo calcolo",
     "das ältere Ergebnis konnte nicht entfernt werden: {1}; was davon bleibt, ist bis zur nächsten Rechnung in {2}",
     "l’ancien résultat n’a pas pu être supprimé\u202F: {1}\u202F; ce qu’il en reste est dans {2} jusqu’au prochain "
     "calcul",
     "el resultado anterior no pudo eliminarse: {1}; lo que queda de él está en {2} hasta el próximo cálculo"},
    {"checkpoint not used: {1}", "punto di ripristino non usato: {1}", "Sicherungspunkt nicht benutzt: {1}",
     "point de reprise non utilisé\u202F: {1}", "punto de control no usado: {1}"},
    {"{1} is no longer needed and cannot be removed: {2}; --resume tries again",
     "{1} non serve più e non può essere rimosso: {2}; --resume riprova",
     "{1} wird nicht mehr gebraucht und kann nicht entfernt werden: {2}; --resume versucht es erneut",
     "{1} n’est plus nécessaire et ne peut être supprimé\u202F: {2}\u202F; --resume réessaie",
     "{1} ya no se necesita y no puede eliminarse: {2}; --resume lo intenta de nuevo"},
    {"{1}: the run stops here", "{1}: il calcolo si ferma qui", "{1}: die Rechnung endet hier",
     "{1}\u202F: le calcul s’arrête ici", "{1}: el cálculo se detiene aquí"},
    {"the checkpoint is from another build ({1}; this is {2}): the result can differ in rounding from that of an "
     "uninterrupted run",
     "il punto di ripristino è di un’altra compilazione ({1}; questa è {2}): il risultato può differire negli "
     "arrotondamenti da quello di un calcolo ininterrotto",
     "der Sicherungspunkt stammt von einem anderen Programmbau ({1}; dieser ist {2}): das Ergebnis kann in der Rundung "
     "von dem einer ununterbrochenen Rechnung abweichen",
     "le point de reprise vient d’une autre compilation ({1}\u202F; celle-ci est {2})\u202F: le résultat peut différer "
     "par les arrondis de celui d’un calcul ininterrompu",
     "el punto de control es de otra compilación ({1}; esta es {2}): el resultado puede diferir en el redondeo del de "
     "un cálculo ininterrumpido"},
    {"the run was stopped at {1} s of at most {2} s: the maps are incomplete; the same command with --resume continues "
     "it",
     "il calcolo è stato fermato a {1} s di al massimo {2} s: le mappe sono incomplete; lo stesso comando con --resume "
     "lo continua",
     "die Rechnung wurde bei {1} s von höchstens {2} s angehalten: die Karten sind unvollständig; derselbe Befehl mit "
     "--resume setzt sie fort",
     "le calcul a été arrêté à {1} s sur {2} s au plus\u202F: les cartes sont incomplètes\u202F; la même commande avec "
     "--resume le continue",
     "el cálculo se detuvo a los {1} s de {2} s como máximo: los mapas están incompletos; la misma orden con --resume "
     "lo continúa"},
    {"the surface of the release stands {1} m above the cell beside it, at E {2}, N {3}: a raster of thickness that "
     "lies half a cell off the DTM does that, and the first speeds come from this step",
     "la superficie del distacco sta {1} m sopra la cella accanto, a E {2}, N {3}: così fa un raster di spessore "
     "spostato di mezza cella dal DTM, e le prime velocità vengono da questo gradino",
     "die Oberfläche der Anrissmasse steht {1} m über der Zelle daneben, bei E {2}, N {3}: so wirkt ein Raster der "
     "Mächtigkeit, das eine halbe Zelle neben dem DTM liegt, und die ersten Geschwindigkeiten kommen von dieser Stufe",
     "la surface du départ domine de {1} m la maille voisine, en E {2}, N {3}\u202F: c’est l’effet d’un raster "
     "d’épaisseur décalé d’une demi-maille du MNT, et les premières vitesses viennent de cette marche",
     "la superficie de la masa inicial está {1} m por encima de la celda contigua, en E {2}, N {3}: así ocurre con un "
     "ráster de espesor desplazado media celda del MDT, y las primeras velocidades vienen de este escalón"},
    {"a release of {1} m2 is {2} m thick on average: the equations hold for masses much wider than thick",
     "un distacco di {1} m2 è spesso in media {2} m: le equazioni valgono per masse molto più larghe che spesse",
     "ein Anriss von {1} m2 ist im Mittel {2} m mächtig: die Gleichungen gelten für Massen, die viel breiter als "
     "mächtig sind",
     "un départ de {1} m2 est épais de {2} m en moyenne\u202F: les équations valent pour des masses bien plus larges "
     "qu’épaisses",
     "una masa inicial de {1} m2 tiene en promedio {2} m de espesor: las ecuaciones valen para masas mucho más anchas "
     "que espesas"},
    {"the run starts with {1} particles only: area and run-out change much with smaller cells; reduce "
     "terrain.cell-size, and see frana converge",
     "il calcolo inizia con sole {1} particelle: area e distanza di propagazione cambiano molto con celle più piccole; "
     "ridurre terrain.cell-size, e vedere frana converge",
     "die Rechnung beginnt mit nur {1} Partikeln: Fläche und Auslauflänge ändern sich stark mit kleineren Zellen; "
     "terrain.cell-size verkleinern, siehe auch frana converge",
     "le calcul commence avec {1} particules seulement\u202F: surface et distance de propagation changent beaucoup "
     "avec "
     "des mailles plus petites\u202F; réduire terrain.cell-size, et voir frana converge",
     "el cálculo empieza con solo {1} partículas: área y alcance cambian mucho con celdas más pequeñas; reduzca "
     "terrain.cell-size, y vea frana converge"},
    {"the energy rises without cause by {1} % of the work of gravity: speeds and run-out may be too great; compare "
     "with "
     "a run on smaller cells",
     "l’energia cresce senza causa del {1} % del lavoro della gravità: velocità e distanza di propagazione possono "
     "essere troppo grandi; confrontare con un calcolo su celle più piccole",
     "die Energie nimmt ohne Ursache um {1} % der Arbeit der Schwerkraft zu: Geschwindigkeiten und Auslauflänge können "
     "zu groß sein; mit einer Rechnung auf kleineren Zellen vergleichen",
     "l’énergie augmente sans cause de {1}\u202F% du travail de la pesanteur\u202F: vitesses et distance de "
     "propagation "
     "peuvent être trop grandes\u202F; comparer à un calcul sur des mailles plus petites",
     "la energía aumenta sin causa en un {1} % del trabajo de la gravedad: velocidades y alcance pueden ser demasiado "
     "grandes; compare con un cálculo en celdas más pequeñas"},
});

}  // namespace

std::span<const WordRow> result_warning_words() {
    return k_result_warning_words;
}

}  // namespace frana
