// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_key_words_method = std::to_array<WordRow>({
    {"Numerical scheme: frana's own, or the method as published.",
     "Schema numerico: quello di frana, o il metodo come pubblicato.",
     "Numerisches Schema: das von frana oder das Verfahren wie veröffentlicht.",
     "Schéma numérique\u202F: celui de frana, ou la méthode telle que publiée.",
     "Esquema numérico: el de frana, o el método tal como se publicó."},
    {"Shape functions; auto: the scheme's (default: quadratic, paper: bilinear).",
     "Funzioni di forma; auto: quelle dello schema (default: quadratic, paper: bilinear).",
     "Formfunktionen; auto: die des Schemas (default: quadratic, paper: bilinear).",
     "Fonctions de forme\u202F; auto\u202F: celles du schéma (default\u202F: quadratic, paper\u202F: bilinear).",
     "Funciones de forma; auto: las del esquema (default: quadratic, paper: bilinear)."},
    {"Velocity transfer to the particles; auto: the scheme's (default: apic, paper: pic).",
     "Trasferimento della velocità alle particelle; auto: quello dello schema (default: apic, paper: pic).",
     "Übertragung der Geschwindigkeit auf die Partikel; auto: die des Schemas (default: apic, paper: pic).",
     "Transfert de la vitesse aux particules\u202F; auto\u202F: celui du schéma (default\u202F: apic, paper\u202F: "
     "pic).",
     "Transferencia de la velocidad a las partículas; auto: la del esquema (default: apic, paper: pic)."},
    {"Particles per cell of the release at the start.", "Particelle per cella del distacco all’inizio.",
     "Partikel je Zelle des Anrisses am Anfang.", "Particules par maille de la zone de départ au début.",
     "Partículas por celda del inicio al comienzo."},
    {"Courant number: fraction of the largest stable time step.",
     "Numero di Courant: frazione del passo temporale stabile più grande.",
     "Courant-Zahl: Anteil am größten stabilen Zeitschritt.",
     "Nombre de Courant\u202F: fraction du plus grand pas de temps stable.",
     "Número de Courant: fracción del mayor paso de tiempo estable."},
    {"Keep still water at rest by a reference level per node (default scheme).",
     "Mantenere ferma l’acqua in quiete con un livello di riferimento per nodo (schema default).",
     "Ruhendes Wasser durch ein Bezugsniveau je Knoten in Ruhe halten (Schema default).",
     "Maintenir l’eau immobile au repos par un niveau de référence par nœud (schéma default).",
     "Mantener en reposo el agua quieta con un nivel de referencia por nodo (esquema default)."},
    {"Form of the equations on steep ground; auto: normal for scheme default, none for paper.",
     "Forma delle equazioni su terreno ripido; auto: normal per lo schema default, none per paper.",
     "Form der Gleichungen auf steilem Gelände; auto: normal für Schema default, none für paper.",
     "Forme des équations sur terrain raide\u202F; auto\u202F: normal pour le schéma default, none pour paper.",
     "Forma de las ecuaciones en terreno empinado; auto: normal para el esquema default, none para paper."},
    {"Motion along a curved bed: the speed along the bed is kept where the slope changes, with more friction in "
     "hollows and less over edges; off: the speed in map view is kept. Needs a slope correction.",
     "Moto lungo un fondo curvo: la velocità lungo il fondo si conserva dove cambia la pendenza, con più attrito nelle "
     "concavità e meno sui dossi; off: si conserva la velocità in pianta. Richiede una correzione di pendenza.",
     "Bewegung entlang gekrümmter Sohle: die Geschwindigkeit entlang der Sohle bleibt erhalten, wo sich die Neigung "
     "ändert, mit mehr Reibung in Mulden und weniger über Kanten; off: die Geschwindigkeit im Grundriss bleibt "
     "erhalten. Braucht eine Neigungskorrektur.",
     "Mouvement le long d’un lit courbe\u202F: la vitesse le long du lit est conservée là où la pente change, avec "
     "plus de frottement dans les creux et moins sur les bosses\u202F; off\u202F: la vitesse en plan est conservée. "
     "Nécessite une correction de pente.",
     "Movimiento a lo largo de un lecho curvo: la velocidad a lo largo del lecho se conserva donde cambia la "
     "pendiente, con más fricción en las concavidades y menos sobre los bordes; off: se conserva la velocidad en "
     "planta. Requiere una corrección de pendiente."},
    {"Where the bed falls away faster than a free fall, material flies without friction or pressure and loses the "
     "velocity normal to the bed on landing; off: it stays on the bed. Needs curvature, scheme default and transfer "
     "apic.",
     "Dove il fondo scende più in fretta di una caduta libera, il materiale vola senza attrito né pressione e "
     "all’atterraggio perde la velocità normale al fondo; off: resta sul fondo. Richiede curvature, schema default e "
     "transfer apic.",
     "Wo die Sohle schneller abfällt als ein freier Fall, fliegt das Material ohne Reibung und Druck und verliert bei "
     "der Landung die Geschwindigkeit senkrecht zur Sohle; off: es bleibt auf der Sohle. Braucht curvature, Schema "
     "default und transfer apic.",
     "Là où le lit plonge plus vite qu’une chute libre, le matériau vole sans frottement ni pression et perd à "
     "l’atterrissage la vitesse normale au lit\u202F; off\u202F: il reste sur le lit. Nécessite curvature, le schéma "
     "default et transfer apic.",
     "Donde el lecho desciende más rápido que una caída libre, el material vuela sin fricción ni presión y al "
     "aterrizar pierde la velocidad normal al lecho; off: permanece en el lecho. Requiere curvature, esquema default y "
     "transfer apic."},
    {"Smallest slope of an edge at which material takes off, in the direction of motion; 0: any bump.",
     "Pendenza minima di un ciglio da cui il materiale si stacca in volo, nella direzione del moto; 0: qualsiasi "
     "gobba.",
     "Kleinste Neigung einer Kante, an der Material abhebt, in Bewegungsrichtung; 0: jede Unebenheit.",
     "Pente minimale d’un rebord d’où le matériau décolle, dans la direction du mouvement\u202F; 0\u202F: toute bosse.",
     "Pendiente mínima de un borde en el que el material despega, en la dirección del movimiento; 0: cualquier "
     "resalte."},
    {"Edge of the working grid: open (outflow is counted) or a wall.",
     "Bordo della griglia di lavoro: open (l’uscita è contata) o una parete (wall).",
     "Rand des Arbeitsgitters: offen (open, der Ausfluss wird gezählt) oder eine Wand (wall).",
     "Bord de la grille de travail\u202F: ouvert (open, la sortie est comptée) ou paroi (wall).",
     "Borde de la malla de trabajo: abierto (open, se cuenta la salida) o pared (wall)."},
    {"Acceleration of gravity.", "Accelerazione di gravità.", "Erdbeschleunigung.", "Accélération de la pesanteur.",
     "Aceleración de la gravedad."},
    {"Depth above which a cell counts as reached in maxima and arrival time. Film thinner than ten times it, at most "
     "10 cm, has fewer particles.",
     "Profondità oltre la quale una cella conta come raggiunta nei massimi e nel tempo di arrivo. Un velo più sottile "
     "di dieci volte questo valore, al massimo 10 cm, ha meno particelle.",
     "Tiefe, ab der eine Zelle in Höchstwerten und Ankunftszeit als erreicht gilt. Ein Film, dünner als das Zehnfache "
     "davon, höchstens 10 cm, hat weniger Partikel.",
     "Hauteur au-delà de laquelle une maille compte comme atteinte dans les maxima et le temps d’arrivée. Un film plus "
     "mince que dix fois cette valeur, au plus 10 cm, a moins de particules.",
     "Profundidad a partir de la cual una celda cuenta como alcanzada en los máximos y el tiempo de llegada. Una "
     "película más delgada que diez veces este valor, como máximo 10 cm, tiene menos partículas."},
    {"Arithmetic of the engine.", "Aritmetica del calcolo.", "Rechengenauigkeit der Zahlen.", "Arithmétique du calcul.",
     "Aritmética del cálculo."},
    {"Error allowed by estimate for area, run-out, greatest depth and speed, gauges and cross-sections, as a fraction "
     "of each: coarser cells are computed first and refined only as far as the estimate asks, at most to the scene's "
     "own.",
     "Errore ammesso secondo stima per area, distanza di propagazione, profondità e velocità massime, punti di misura "
     "e sezioni, come frazione di ciascuno: prima si calcolano celle più grandi, raffinate solo quanto la stima "
     "richiede, al massimo fino a quelle della scena.",
     "Laut Schätzung zulässiger Fehler von Fläche, Auslauflänge, größter Tiefe und Geschwindigkeit, Messpunkten und "
     "Querschnitten, als Anteil des jeweiligen Werts: gröbere Zellen werden zuerst gerechnet und nur so weit "
     "verfeinert, wie die Schätzung verlangt, höchstens bis zu denen der Szene.",
     "Erreur admise, selon l’estimation, pour surface, distance de propagation, hauteur et vitesse maximales, points "
     "de mesure et sections, en fraction de chacune\u202F: des mailles plus grandes sont calculées d’abord et affinées "
     "seulement autant que l’estimation le demande, au plus jusqu’à celles de la scène.",
     "Error admitido según estimación para área, alcance, profundidad y velocidad máximas, puntos de medida y "
     "secciones, como fracción de cada uno: primero se calculan celdas mayores, refinadas solo lo que pide la "
     "estimación, como máximo hasta las de la escena."},
    {"Longest simulated time.", "Tempo simulato massimo.", "Längste simulierte Zeit.", "Temps simulé maximal.",
     "Tiempo simulado máximo."},
    {"End as soon as all material is at rest.", "Terminare appena tutto il materiale è fermo.",
     "Enden, sobald alles Material ruht.", "Terminer dès que tout le matériau est au repos.",
     "Terminar en cuanto todo el material esté en reposo."},
    {"End once the kinetic energy is below this fraction of its peak; 0: off.",
     "Terminare quando l’energia cinetica è sotto questa frazione del suo massimo; 0: disattivato.",
     "Enden, wenn die Bewegungsenergie unter diesem Anteil ihres Höchstwerts liegt; 0: aus.",
     "Terminer quand l’énergie cinétique est sous cette fraction de son maximum\u202F; 0\u202F: désactivé.",
     "Terminar cuando la energía cinética esté por debajo de esta fracción de su máximo; 0: desactivado."},
    {"End once the moving volume is below this fraction of its peak; 0: off.",
     "Terminare quando il volume in moto è sotto questa frazione del suo massimo; 0: disattivato.",
     "Enden, wenn das bewegte Volumen unter diesem Anteil seines Höchstwerts liegt; 0: aus.",
     "Terminer quand le volume en mouvement est sous cette fraction de son maximum\u202F; 0\u202F: désactivé.",
     "Terminar cuando el volumen en movimiento esté por debajo de esta fracción de su máximo; 0: desactivado."},
    {"End once the momentum, the sum of mass times speed, is below this fraction of its peak; 0: off. 0.05 is "
     "customary "
     "for avalanches.",
     "Terminare quando la quantità di moto, somma di massa per velocità, è sotto questa frazione del suo massimo; 0: "
     "disattivato. 0,05 è usuale per le valanghe.",
     "Enden, wenn der Impuls, die Summe von Masse mal Geschwindigkeit, unter diesem Anteil seines Höchstwerts liegt; "
     "0: "
     "aus. 0,05 ist bei Lawinen üblich.",
     "Terminer quand la quantité de mouvement, somme des masses par la vitesse, est sous cette fraction de son "
     "maximum\u202F; 0\u202F: désactivé. 0,05 est usuel pour les avalanches.",
     "Terminar cuando la cantidad de movimiento, suma de masa por velocidad, esté por debajo de esta fracción de su "
     "máximo; 0: desactivado. 0,05 es habitual en aludes."},
    {"Speed above which volume counts as moving.", "Velocità oltre la quale il volume conta come in moto.",
     "Geschwindigkeit, ab der Volumen als bewegt gilt.",
     "Vitesse au-delà de laquelle le volume compte comme en mouvement.",
     "Velocidad a partir de la cual el volumen cuenta como en movimiento."},
    {"End once run-out (or by a cell) and area over output.trace-threshold have changed by no more than this fraction "
     "over time.stop-window, and no more than four times this fraction of the volume has changed cell; 0: off.",
     "Terminare quando distanza di propagazione (o di una cella) e area oltre output.trace-threshold sono cambiate di "
     "non più di questa frazione durante time.stop-window, e non più di quattro volte questa frazione del volume ha "
     "cambiato cella; 0: disattivato.",
     "Enden, wenn sich Auslauflänge (oder um eine Zelle) und Fläche über output.trace-threshold während "
     "time.stop-window um höchstens diesen Anteil geändert haben und höchstens das Vierfache dieses Anteils des "
     "Volumens die Zelle gewechselt hat; 0: aus.",
     "Terminer quand distance de propagation (ou d’une maille) et surface au-delà de output.trace-threshold n’ont pas "
     "changé de plus de cette fraction pendant time.stop-window, et que pas plus de quatre fois cette fraction du "
     "volume n’a changé de maille\u202F; 0\u202F: désactivé.",
     "Terminar cuando el alcance (o en una celda) y el área por encima de output.trace-threshold hayan cambiado no más "
     "de esta fracción durante time.stop-window, y no más de cuatro veces esta fracción del volumen haya cambiado de "
     "celda; 0: desactivado."},
    {"Window of time.stop-change: fraction of the time since the last release or inflow, at least 10 s.",
     "Intervallo di time.stop-change: frazione del tempo dall’ultimo distacco o afflusso, almeno 10 s.",
     "Zeitfenster von time.stop-change: Anteil der Zeit seit dem letzten Anriss oder Zufluss, mindestens 10 s.",
     "Fenêtre de time.stop-change\u202F: fraction du temps écoulé depuis le dernier départ ou afflux, au moins 10 s.",
     "Ventana de time.stop-change: fracción del tiempo desde el último inicio o entrada, al menos 10 s."},
    {"Simulated time between frames; each is the first state at or after its time.",
     "Tempo simulato fra le istantanee; ciascuna è il primo stato al suo istante o dopo.",
     "Simulierte Zeit zwischen den Momentaufnahmen; jede ist der erste Zustand zu oder nach ihrem Zeitpunkt.",
     "Temps simulé entre les instantanés\u202F; chacun est le premier état à son instant ou après.",
     "Tiempo simulado entre instantáneas; cada una es el primer estado en su instante o después."},
});

}  // namespace

std::span<const WordRow> key_words_method() {
    return k_key_words_method;
}

}  // namespace frana
