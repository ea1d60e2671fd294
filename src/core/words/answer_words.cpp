// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_answer_words = std::to_array<WordRow>({
    {"Scenario and answer", "Scenario e risposta", "Szenario und Antwort", "Scénario et réponse",
     "Escenario y respuesta"},
    {"What fails.", "Che cosa frana.", "Was bricht los.", "Ce qui part.", "Qué falla."},
    {"One area fails{1}:", "Frana un’area{1}:", "Eine Fläche bricht los{1}:", "Une zone part{1}\u202F:",
     "Falla un área{1}:"},
    {"{1} areas fail{2}:", "Franano {1} aree{2}:", "{1} Flächen brechen los{2}:", "{1} zones partent{2}\u202F:",
     "Fallan {1} áreas{2}:"},
    {"{1} m³ from {2} m² in map view, {3} m thick on average and {4} m at most, vertical.",
     "{1} m³ da {2} m² in pianta, spessore verticale {3} m in media e {4} m al massimo.",
     "{1} m³ von {2} m² im Grundriss, im Mittel {3} m und höchstens {4} m mächtig (vertikal).",
     "{1} m³ sur {2} m² en plan, épaisseur verticale de {3} m en moyenne et de {4} m au plus.",
     "{1} m³ de {2} m² en planta, con espesor vertical de {3} m en promedio y {4} m como máximo."},
    {"{1} m³ flow in through lines.", "{1} m³ affluiscono attraverso linee.", "{1} m³ fließen durch Linien zu.",
     "{1} m³ affluent par des lignes.", "{1} m³ entran por líneas."},
    {"On its way the flow erodes {1} m³ and deposits {2} m³ on the bed.",
     "Lungo il percorso la colata erode {1} m³ e deposita {2} m³ sul fondo.",
     "Unterwegs erodiert der Strom {1} m³ und lagert {2} m³ auf der Sohle ab.",
     "En chemin, l’écoulement érode {1} m³ et dépose {2} m³ sur le lit.",
     "En su camino el flujo erosiona {1} m³ y deposita {2} m³ en el lecho."},
    {"Friction and material.", "Attrito e materiale.", "Reibung und Material.", "Frottement et matériau.",
     "Fricción y material."},
    {"Voellmy-Bingham model:", "Modello di Voellmy-Bingham:", "Voellmy-Bingham-Modell:",
     "Modèle de Voellmy-Bingham\u202F:", "Modelo de Voellmy-Bingham:"},
    {"Structured two-phase model.", "Modello strutturato a due fasi.", "Strukturiertes Zweiphasenmodell.",
     "Modèle structuré à deux phases.", "Modelo estructurado de dos fases."},
    {"Values: {1}.", "Valori: {1}.", "Werte: {1}.", "Valeurs\u202F: {1}.", "Valores: {1}."},
    {"{1} {2} by place (zones of {3})", "{1} {2} secondo il luogo (zone di {3})", "{1} {2} je nach Ort (Zonen aus {3})",
     "{1} {2} selon le lieu (zones de {3})", "{1} {2} según el lugar (zonas de {3})"},
    {"Source of the preset {1}:", "Fonte del preset {1}:", "Quelle der Voreinstellung {1}:",
     "Source du préréglage {1}\u202F:", "Fuente del ajuste predefinido {1}:"},
    {"Where it goes.", "Dove va.", "Wohin es geht.", "Où cela va.", "Adónde va."},
    {"Run-out {1} m: straight in map view, from the top of the release to the farthest place reached, {2} m lower: "
     "angle of reach {3}°.",
     "Distanza di propagazione {1} m: in linea retta in pianta, dalla sommità del distacco al punto più lontano "
     "raggiunto, {2} m più in basso: angolo di propagazione {3}°.",
     "Reichweite {1} m: gerade im Grundriss, vom höchsten Punkt des Anrisses zum fernsten erreichten Ort, {2} m "
     "tiefer: "
     "Pauschalgefälle {3}°.",
     "Distance de propagation {1} m\u202F: en ligne droite en plan, du sommet du départ au lieu atteint le plus "
     "éloigné, {2} m plus bas\u202F: angle de propagation {3}°.",
     "Alcance {1} m: en línea recta en planta, desde lo alto de la zona de inicio hasta el lugar alcanzado más lejano, "
     "{2} m más abajo: ángulo de alcance {3}°."},
    {"Along the flow path it is {1} m, at {2}°.", "Lungo il percorso della colata è {1} m, a {2}°.",
     "Entlang des Fließwegs sind es {1} m bei {2}°.", "Le long du trajet de l’écoulement elle est de {1} m, à {2}°.",
     "A lo largo de la trayectoria del flujo es de {1} m, a {2}°."},
    {"Run-out along the flow path", "Distanza lungo il percorso", "Reichweite entlang des Fließwegs",
     "Distance le long du trajet", "Alcance a lo largo de la trayectoria"},
    {"Angle along the flow path", "Angolo lungo il percorso", "Winkel entlang des Fließwegs", "Angle le long du trajet",
     "Ángulo a lo largo de la trayectoria"},
    {"{1} m² are deeper than {2} m at some time.", "{1} m² sono coperti per più di {2} m in qualche momento.",
     "{1} m² sind irgendwann tiefer als {2} m bedeckt.", "{1} m² sont couverts de plus de {2} m à un moment.",
     "{1} m² quedan cubiertos por más de {2} m en algún momento."},
    {"The greatest depth is {1} m, the greatest speed {2} m/s.",
     "La profondità massima è {1} m, la velocità massima {2} m/s.",
     "Die größte Fließtiefe ist {1} m, die größte Geschwindigkeit {2} m/s.",
     "La hauteur maximale est de {1} m, la vitesse maximale de {2} m/s.",
     "La profundidad máxima es de {1} m y la velocidad máxima de {2} m/s."},
    {"But for a thousandth of that area the flow is at most {1} deep and {2} m/s fast (one cell: {3} m vertical, "
     "{4} m normal to a bed of {5}°, after {6} s at E {7}, N {8}; one cell: {9} m/s).",
     "Salvo su un millesimo di quell’area il flusso è profondo al massimo {1} e veloce {2} m/s (una cella: {3} m in "
     "verticale, {4} m normali a un letto di {5}°, dopo {6} s a E {7}, N {8}; una cella: {9} m/s).",
     "Außer auf einem Tausendstel dieser Fläche ist der Strom höchstens {1} tief und {2} m/s schnell (eine Zelle: {3} "
     "m lotrecht, {4} m senkrecht zu einem Bett von {5}°, nach {6} s bei E {7}, N {8}; eine Zelle: {9} m/s).",
     "Sauf sur un millième de cette surface l’écoulement a au plus {1} de hauteur et {2} m/s de vitesse (une "
     "maille\u202F: {3} m verticaux, {4} m normaux à un lit de {5}°, après {6} s à E {7}, N {8}\u202F; une "
     "maille\u202F: {9} m/s).",
     "Salvo en una milésima de esa superficie el flujo tiene como máximo {1} de profundidad y {2} m/s de velocidad "
     "(una celda: {3} m en vertical, {4} m normales a un lecho de {5}°, a los {6} s en E {7}, N {8}; una celda: {9} "
     "m/s)."},
    {"{1} flows never met; the run-out is that of the longest.",
     "{1} colate non si sono mai unite; la distanza di propagazione è quella della più lunga.",
     "{1} Ströme trafen sich nie; die Auslauflänge ist die des längsten.",
     "{1} écoulements ne se sont jamais rejoints\u202F; la distance de propagation est celle du plus long.",
     "{1} flujos nunca se unieron; el alcance es el del más largo."},
    {"First arrival at gauges: {1}.", "Primo arrivo ai punti di misura: {1}.", "Erste Ankunft an den Messpunkten: {1}.",
     "Première arrivée aux points de mesure\u202F: {1}.", "Primera llegada a los puntos de medida: {1}."},
    {"{1} after {2} s", "{1} dopo {2} s", "{1} nach {2} s", "{1} après {2} s", "{1} a los {2} s"},
    {"{1} is not reached", "{1} non è raggiunto", "{1} wird nicht erreicht", "{1} n’est pas atteint",
     "{1} no se alcanza"},
    {"How sure.", "Quanto è sicuro.", "Wie sicher.", "Avec quelle certitude.", "Con qué certeza."},
    {"On cells of {1} m; there is no estimate of the error from their size (frana converge or numerics.accuracy gives "
     "one).",
     "Su celle di {1} m; non c’è una stima dell’errore dovuto alla loro dimensione (la danno frana converge o "
     "numerics.accuracy).",
     "Auf Zellen von {1} m; der Fehler durch ihre Größe ist nicht geschätzt (das tun frana converge oder "
     "numerics.accuracy).",
     "Sur des mailles de {1} m\u202F; l’erreur due à leur taille n’est pas estimée (frana converge ou "
     "numerics.accuracy l’estiment).",
     "Con celdas de {1} m; no hay estimación del error debido a su tamaño (la dan frana converge o "
     "numerics.accuracy)."},
    {"On cells of {1} m; the error from their size is estimated and stands beside the values (±).",
     "Su celle di {1} m; l’errore dovuto alla loro dimensione è stimato e sta accanto ai valori (±).",
     "Auf Zellen von {1} m; der Fehler durch ihre Größe ist geschätzt und steht neben den Werten (±).",
     "Sur des mailles de {1} m\u202F; l’erreur due à leur taille est estimée et figure à côté des valeurs (±).",
     "Con celdas de {1} m; el error debido a su tamaño está estimado y figura junto a los valores (±)."},
    {"The volume is conserved to {1} %.", "Il volume è conservato entro {1} %.",
     "Das Volumen bleibt auf {1} % erhalten.", "Le volume est conservé à {1}\u202F% près.",
     "El volumen se conserva con un error de {1} %."},
    {"The volume is conserved to {1} %, the energy rises without cause by at most {2} %.",
     "Il volume è conservato entro {1} %, l’energia cresce senza causa al più di {2} %.",
     "Das Volumen bleibt auf {1} % erhalten, die Energie steigt ohne Ursache um höchstens {2} %.",
     "Le volume est conservé à {1}\u202F% près, l’énergie croît sans cause de {2}\u202F% au plus.",
     "El volumen se conserva con un error de {1} %, la energía crece sin causa como máximo {2} %."},
    {"The run ended after {1} s: {2}; greatest speed then {3} m/s.",
     "Il calcolo è finito dopo {1} s: {2}; velocità massima a quel momento {3} m/s.",
     "Die Rechnung endete nach {1} s: {2}; größte Geschwindigkeit dann {3} m/s.",
     "Le calcul s’est terminé après {1} s\u202F: {2}\u202F; vitesse maximale alors {3} m/s.",
     "El cálculo terminó a los {1} s: {2}; velocidad máxima entonces {3} m/s."},
    {"Run-out and area have stopped changing; the deposit still creeps at up to {1} m/s.",
     "Distanza di propagazione e area non cambiano più; il deposito scorre ancora, al massimo a {1} m/s.",
     "Reichweite und Fläche ändern sich nicht mehr; die Ablagerung kriecht noch mit höchstens {1} m/s.",
     "Distance de propagation et surface ne changent plus\u202F; le dépôt flue encore, au plus à {1} m/s.",
     "Alcance y superficie ya no cambian; el depósito aún repta, como máximo a {1} m/s."},
    {"Material was still moving: final depth and run-out are not those of the deposit.",
     "Il materiale era ancora in moto: profondità finale e distanza di propagazione non sono quelle del deposito.",
     "Material bewegte sich noch: Endtiefe und Auslauflänge sind nicht die der Ablagerung.",
     "Du matériau bougeait encore\u202F: la hauteur finale et la distance de propagation ne sont pas celles du dépôt.",
     "El material aún se movía: la profundidad final y el alcance no son los del depósito."},
    {"{1} m³ ({2} %) left the computed ground: the full run-out is not shown.",
     "{1} m³ ({2} %) hanno lasciato il terreno calcolato: la distanza di propagazione completa non è mostrata.",
     "{1} m³ ({2} %) verließen das berechnete Gelände: die volle Auslauflänge ist nicht dargestellt.",
     "{1} m³ ({2}\u202F%) ont quitté le terrain calculé\u202F: la distance de propagation complète n’est pas montrée.",
     "{1} m³ ({2} %) salieron del terreno calculado: el alcance completo no se muestra."},
    {"{1} m³ flew over edges, in all jumps together, at most {2} m above the ground and {3} m far: where all passes "
     "overhead, the maps of depth, speed and pressure show none.",
     "{1} m³ hanno volato oltre spigoli, in tutti i salti insieme, al massimo {2} m sopra il terreno e per {3} m: dove "
     "tutto passa in volo, le mappe di profondità, velocità e pressione non mostrano nulla.",
     "{1} m³ flogen über Kanten, in allen Sprüngen zusammen, höchstens {2} m über dem Gelände und {3} m weit: wo alles "
     "in der Luft vorbeizieht, zeigen die Karten von Tiefe, Geschwindigkeit und Druck nichts.",
     "{1} m³ ont volé par-dessus des arêtes, en tous les sauts, au plus à {2} m du sol et sur {3} m\u202F: là où tout "
     "passe en l’air, les cartes de hauteur, vitesse et pression ne montrent rien.",
     "{1} m³ volaron sobre bordes, en todos los saltos juntos, como máximo a {2} m del suelo y por {3} m: donde todo "
     "pasa por el aire, los mapas de profundidad, velocidad y presión no muestran nada."},
    {"There were numerical events that do not occur in a good run.",
     "Ci sono stati eventi numerici che in un buon calcolo non avvengono.",
     "Es gab numerische Ereignisse, die in einer guten Rechnung nicht vorkommen.",
     "Il y a eu des événements numériques qui n’arrivent pas dans un bon calcul.",
     "Hubo eventos numéricos que no ocurren en un buen cálculo."},
    {"Against the survey.", "Rispetto al rilievo.", "Gegen die Aufnahme.", "Par rapport au relevé.",
     "Frente al levantamiento."},
    {"Not compared with an observed outline (frana compare does it).",
     "Non confrontato con un perimetro rilevato (lo fa frana compare).",
     "Nicht mit einem kartierten Umriss verglichen (das tut frana compare).",
     "Pas comparé à un contour levé (frana compare le fait).",
     "No comparado con un contorno levantado (lo hace frana compare)."},
    {"Of the observed area {1} % is hit; {2} m² are covered beyond it. Jaccard index {3} (1: perfect), areas differ by "
     "{4} %.",
     "Dell’area osservata è colpito il {1} %; {2} m² sono coperti oltre. Indice di Jaccard {3} (1: perfetto), le aree "
     "differiscono del {4} %.",
     "Von der beobachteten Fläche sind {1} % getroffen; {2} m² sind darüber hinaus bedeckt. Jaccard-Index {3} (1: "
     "perfekt), die Flächen unterscheiden sich um {4} %.",
     "De la surface observée, {1}\u202F% sont atteints\u202F; {2} m² sont couverts au-delà. Indice de Jaccard {3} "
     "(1\u202F: "
     "parfait), les surfaces diffèrent de {4}\u202F%.",
     "Del área observada se alcanza el {1} %; {2} m² quedan cubiertos fuera de ella. Índice de Jaccard {3} (1: "
     "perfecto), las áreas difieren en {4} %."},
    {"Run-out, simulated minus observed: {1} m.", "Distanza di propagazione, simulata meno osservata: {1} m.",
     "Auslauflänge, simuliert minus beobachtet: {1} m.",
     "Distance de propagation, simulée moins observée\u202F: {1} m.", "Alcance, simulado menos observado: {1} m."},
    {"The distances are in the table of the comparison.", "Le distanze sono nella tabella del confronto.",
     "Die Abstände stehen in der Tabelle des Vergleichs.", "Les distances sont dans le tableau de la comparaison.",
     "Las distancias están en la tabla de la comparación."},
    {"Warnings", "Avvisi", "Warnungen", "Avertissements", "Advertencias"},
    {"Warning:", "Avviso:", "Warnung:", "Avertissement\u202F:", "Advertencia:"},
    {"The run gave no warnings.", "Il calcolo non ha dato avvisi.", "Die Rechnung gab keine Warnungen.",
     "Le calcul n’a donné aucun avertissement.", "El cálculo no dio advertencias."},
    {"{1} warnings in all, see below.", "{1} avvisi in tutto, vedi sotto.", "Insgesamt {1} Warnungen, siehe unten.",
     "{1} avertissements en tout, voir plus bas.", "{1} advertencias en total, véase abajo."},
    {"Not done.", "Che cosa manca.", "Nicht getan.", "Ce qui n’est pas fait.", "Lo que no se hizo."},
    {"This is one run with one set of values, not a range of what is possible: frana ensemble computes the range, "
     "frana calibrate fits the values to observed events.",
     "È un solo calcolo con un solo insieme di valori, non un campo di ciò che è possibile: frana ensemble calcola il "
     "campo, frana calibrate adatta i valori a eventi osservati.",
     "Dies ist eine Rechnung mit einem Satz von Werten, keine Spanne des Möglichen: frana ensemble berechnet die "
     "Spanne, frana calibrate passt die Werte an beobachtete Ereignisse an.",
     "C’est un seul calcul avec un seul jeu de valeurs, non l’étendue du possible\u202F: frana ensemble calcule "
     "l’étendue, frana calibrate ajuste les valeurs à des événements observés.",
     "Es un solo cálculo con un solo conjunto de valores, no el rango de lo posible: frana ensemble calcula el rango, "
     "frana calibrate ajusta los valores a eventos observados."},
    {"Where it goes", "Dove va", "Wohin es geht", "Où cela va", "Adónde va"},
    {"How strong, at most", "Con quale forza, al massimo", "Wie stark, höchstens", "Avec quelle force, au plus",
     "Con qué fuerza, como máximo"},
    {"± by cell size", "± per le celle", "± durch Zellgröße", "± dû aux mailles", "± por las celdas"},
    {"no estimate", "nessuna stima", "keine Schätzung", "pas d’estimation", "sin estimación"},
    {"not converging", "non converge", "nicht konvergierend", "ne converge pas", "no converge"},
    {"Volume that came in", "Volume entrato", "Zugeführtes Volumen", "Volume entré", "Volumen que entró"},
    {"Run-out, in map view", "Distanza di propagazione, in pianta", "Auslauflänge, im Grundriss",
     "Distance de propagation, en plan", "Alcance, en planta"},
    {"Drop", "Dislivello", "Fallhöhe", "Dénivelé", "Desnivel"},
    {"Angle of reach", "Angolo di propagazione", "Pauschalgefälle", "Angle de propagation", "Ángulo de alcance"},
    {"Area deeper than {1} m", "Area più profonda di {1} m", "Fläche tiefer als {1} m", "Surface de plus de {1} m",
     "Área más profunda que {1} m"},
    {"on 99.9 % of the area", "sul 99,9 % dell’area", "auf 99,9 % der Fläche", "sur 99,9\u202F% de la surface",
     "en el 99,9 % del área"},
    {"Computed with {1}, scene {2}, hash {3}", "Calcolato con {1}, scena {2}, hash {3}",
     "Berechnet mit {1}, Szene {2}, Hash {3}", "Calculé avec {1}, scène {2}, hachage {3}",
     "Calculado con {1}, escena {2}, hash {3}"},
    {"Maps", "Mappe", "Karten", "Cartes", "Mapas"},
    {"The scene asks for no maps.", "La scena non chiede mappe.", "Die Szene verlangt keine Karten.",
     "La scène ne demande pas de cartes.", "La escena no pide mapas."},
    {"No map could be drawn; see the warnings.", "Nessuna mappa ha potuto essere disegnata; vedi gli avvisi.",
     "Keine Karte konnte gezeichnet werden; siehe die Warnungen.",
     "Aucune carte n’a pu être dessinée\u202F; voir les avertissements.",
     "No se pudo dibujar ningún mapa; véanse las advertencias."},
    {"The only map is on the first page.", "L’unica mappa è nella prima pagina.",
     "Die einzige Karte steht auf der ersten Seite.", "La seule carte est en première page.",
     "El único mapa está en la primera página."},
    {"in perspective", "in prospettiva", "perspektivisch", "en perspective", "en perspectiva"},
    {"at most {1}", "al massimo {1}", "höchstens {1}", "au plus {1}", "como máximo {1}"},
    {"Map. {1}. Covered {2} m² deeper than {3} m, run-out {4} m",
     "Mappa. {1}. Coperti {2} m² oltre {3} m di profondità, distanza di propagazione {4} m",
     "Karte. {1}. Bedeckt sind {2} m² tiefer als {3} m, Auslauflänge {4} m",
     "Carte. {1}. {2} m² couverts de plus de {3} m, distance de propagation {4} m",
     "Mapa. {1}. Cubiertos {2} m² a más de {3} m de profundidad, alcance {4} m"},
    {"View of the slope. {1}. Covered {2} m² deeper than {3} m, run-out {4} m",
     "Veduta del versante. {1}. Coperti {2} m² oltre {3} m di profondità, distanza di propagazione {4} m",
     "Ansicht des Hangs. {1}. Bedeckt sind {2} m² tiefer als {3} m, Auslauflänge {4} m",
     "Vue du versant. {1}. {2} m² couverts de plus de {3} m, distance de propagation {4} m",
     "Vista de la ladera. {1}. Cubiertos {2} m² a más de {3} m de profundidad, alcance {4} m"},
    {"Course of the flow", "Andamento della colata", "Verlauf des Stroms", "Déroulement de l’écoulement",
     "Curso del flujo"},
    {"Curve over time: {1}, at most {2}", "Curva nel tempo: {1}, al massimo {2}",
     "Kurve über der Zeit: {1}, höchstens {2}", "Courbe dans le temps\u202F: {1}, au plus {2}",
     "Curva en el tiempo: {1}, como máximo {2}"},
    {"Curves over time: {1}", "Curve nel tempo: {1}", "Kurven über der Zeit: {1}", "Courbes dans le temps\u202F: {1}",
     "Curvas en el tiempo: {1}"},
    {"time [s]", "tempo [s]", "Zeit [s]", "temps [s]", "tiempo [s]"},
    {"front from the release's centroid [m]", "fronte dal baricentro del distacco [m]",
     "Front ab Schwerpunkt des Anrisses [m]", "front depuis le centre du départ [m]",
     "frente desde el centro del inicio [m]"},
    {"greatest speed [m/s]", "velocità massima [m/s]", "größte Geschwindigkeit [m/s]", "vitesse maximale [m/s]",
     "velocidad máxima [m/s]"},
    {"greatest depth [m]", "profondità massima [m]", "größte Fließtiefe [m]", "hauteur maximale [m]",
     "profundidad máxima [m]"},
    {"covered area [m²]", "area coperta [m²]", "bedeckte Fläche [m²]", "surface couverte [m²]", "área cubierta [m²]"},
    {"depth at the gauges [m]", "profondità ai punti di misura [m]", "Fließtiefe an den Messpunkten [m]",
     "hauteur aux points de mesure [m]", "profundidad en los puntos de medida [m]"},
    {"discharge through the cross-sections [m³/s]", "portata attraverso le sezioni [m³/s]",
     "Abfluss durch die Querschnitte [m³/s]", "débit à travers les sections [m³/s]",
     "caudal a través de las secciones [m³/s]"},
});

}  // namespace

std::span<const WordRow> answer_words() {
    return k_answer_words;
}

}  // namespace frana
