// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_key_words_site = std::to_array<WordRow>({
    {"Format of the file, written into a result's scene.ini.",
     "Formato del file, scritto nello scene.ini di un risultato.",
     "Format der Datei; steht in der scene.ini eines Ergebnisses.",
     "Format du fichier, écrit dans le scene.ini d’un résultat.",
     "Formato del archivo, escrito en el scene.ini de un resultado."},
    {"Digital terrain model: any raster that GDAL reads, with elevations in its first band.",
     "Modello digitale del terreno (DTM): qualsiasi raster letto da GDAL, con le quote nella prima banda.",
     "Digitales Geländemodell (DGM): jedes Raster, das GDAL liest, mit den Höhen im ersten Band.",
     "Modèle numérique de terrain (MNT)\u202F: tout raster lu par GDAL, avec les altitudes dans la première bande.",
     "Modelo digital del terreno (MDT): cualquier ráster que lea GDAL, con las cotas en la primera banda."},
    {"Working CRS, projected, in metres (EPSG:32632, WKT, PROJ); auto: the DTM's own if it is projected in metres, "
     "otherwise the local UTM zone; local: plain metres without a CRS.",
     "SR di lavoro, proiettato, in metri (EPSG:32632, WKT, PROJ); auto: quello del DTM se è proiettato in metri, "
     "altrimenti la zona UTM locale; local: semplici metri senza SR.",
     "Arbeits-KBS, projiziert, in Metern (EPSG:32632, WKT, PROJ); auto: das des DGM, wenn es in Metern projiziert ist, "
     "sonst die örtliche UTM-Zone; local: bloße Meter ohne KBS.",
     "SCR de travail, projeté, en mètres (EPSG:32632, WKT, PROJ)\u202F; auto\u202F: celui du MNT s’il est projeté en "
     "mètres, sinon la zone UTM locale\u202F; local\u202F: de simples mètres sans SCR.",
     "SRC de trabajo, proyectado, en metros (EPSG:32632, WKT, PROJ); auto: el del MDT si está proyectado en metros, si "
     "no la zona UTM local; local: simples metros sin SRC."},
    {"CRS of the DTM, if its file names none or a wrong one.",
     "SR del DTM, se il suo file non ne indica alcuno o ne indica uno errato.",
     "KBS des DGM, wenn seine Datei keines oder ein falsches nennt.",
     "SCR du MNT, si son fichier n’en indique aucun ou en indique un faux.",
     "SRC del MDT, si su archivo no indica ninguno o indica uno erróneo."},
    {"Cell size of the working grid.", "Dimensione delle celle della griglia di lavoro.",
     "Zellgröße des Arbeitsgitters.", "Taille des mailles de la grille de travail.",
     "Tamaño de celda de la malla de trabajo."},
    {"Part of the DTM to compute on: west south east north in the working CRS.",
     "Parte del DTM su cui calcolare: ovest sud est nord nel SR di lavoro.",
     "Teil des DGM, auf dem gerechnet wird: West Süd Ost Nord im Arbeits-KBS.",
     "Partie du MNT sur laquelle calculer\u202F: ouest sud est nord dans le SCR de travail.",
     "Parte del MDT en la que se calcula: oeste sur este norte en el SRC de trabajo."},
    {"Where the flow reaches ground without elevation: end the run, treat it as a wall, or interpolate the bed "
     "beforehand.",
     "Dove la colata raggiunge terreno senza quota: terminare il calcolo, trattarlo come una parete o interpolare "
     "prima il fondo.",
     "Wo der Strom Gelände ohne Höhe erreicht: die Rechnung beenden, es als Wand behandeln oder die Sohle vorher "
     "interpolieren.",
     "Là où l’écoulement atteint un terrain sans altitude\u202F: arrêter le calcul, le traiter comme une paroi ou "
     "interpoler le lit au préalable.",
     "Donde el flujo llega a terreno sin cota: terminar el cálculo, tratarlo como pared o interpolar antes el lecho."},
    {"Unit of the DTM's elevations; auto: as stated in the file, otherwise metres.",
     "Unità delle quote del DTM; auto: come indicata nel file, altrimenti metri.",
     "Einheit der Höhen des DGM; auto: wie in der Datei angegeben, sonst Meter.",
     "Unité des altitudes du MNT\u202F; auto\u202F: celle indiquée dans le fichier, sinon le mètre.",
     "Unidad de las cotas del MDT; auto: la indicada en el archivo, si no metros."},
    {"Resampling of the DTM to the working grid; automatic: copied if the cells coincide, averaged to coarser cells, "
     "bilinear to finer ones.",
     "Ricampionamento del DTM sulla griglia di lavoro; automatic: copiato se le celle coincidono, mediato su celle più "
     "grandi, bilineare su celle più piccole.",
     "Umrechnung des DGM auf das Arbeitsgitter; automatic: übernommen, wenn die Zellen zusammenfallen, gemittelt auf "
     "gröbere Zellen, bilinear auf feinere.",
     "Rééchantillonnage du MNT sur la grille de travail\u202F; automatic\u202F: copié si les mailles coïncident, "
     "moyenné vers des mailles plus grandes, bilinéaire vers de plus petites.",
     "Remuestreo del MDT a la malla de trabajo; automatic: copiado si las celdas coinciden, promediado a celdas "
     "mayores, bilineal a celdas menores."},
    {"Source of the elevations, named on maps: survey, owner, date, licence.",
     "Fonte delle quote, indicata sulle mappe: rilievo, proprietario, data, licenza.",
     "Quelle der Höhen, die auf Karten genannt wird: Aufnahme, Eigentümer, Datum, Lizenz.",
     "Source des altitudes, indiquée sur les cartes\u202F: levé, propriétaire, date, licence.",
     "Fuente de las cotas, indicada en los mapas: levantamiento, propietario, fecha, licencia."},
    {"Polygons with different material values, in their own CRS; [zones] names the columns.",
     "Poligoni con valori diversi del materiale, nel proprio SR; [zones] indica le colonne.",
     "Polygone mit anderen Materialwerten, in eigenem KBS; [zones] nennt die Spalten.",
     "Polygones aux valeurs de matériau différentes, dans leur propre SCR\u202F; [zones] indique les colonnes.",
     "Polígonos con otros valores del material, en su propio SRC; [zones] indica las columnas."},
    {"Polygons of dams, fills and embankments that raise the bed, in their own CRS.",
     "Poligoni di briglie, rilevati e terrapieni che alzano il fondo, nel proprio SR.",
     "Polygone von Dämmen, Aufschüttungen und Wällen, die die Sohle anheben, in eigenem KBS.",
     "Polygones de digues, remblais et levées qui rehaussent le lit, dans leur propre SCR.",
     "Polígonos de presas, rellenos y terraplenes que elevan el lecho, en su propio SRC."},
    {"Height of the obstacles above the DTM.", "Altezza degli ostacoli sopra il DTM.",
     "Höhe der Hindernisse über dem DGM.", "Hauteur des obstacles au-dessus du MNT.",
     "Altura de los obstáculos sobre el MDT."},
    {"Polygons of buildings and walls that the flow cannot overtop, in their own CRS.",
     "Poligoni di edifici e muri che la colata non può sormontare, nel proprio SR.",
     "Polygone von Gebäuden und Mauern, die der Strom nicht überströmen kann, in eigenem KBS.",
     "Polygones de bâtiments et de murs que l’écoulement ne peut pas franchir, dans leur propre SCR.",
     "Polígonos de edificios y muros que el flujo no puede rebasar, en su propio SRC."},
    {"Error added to the elevations of the DTM: a normal random field with this standard deviation, whose correlation "
     "falls to 0.05 at the range; each seed is another field.",
     "Errore aggiunto alle quote del DTM: un campo casuale normale con questa deviazione standard, la cui correlazione "
     "scende a 0,05 alla distanza data; ogni seme è un altro campo.",
     "Fehler, der zu den Höhen des DGM addiert wird: ein normalverteiltes Zufallsfeld mit dieser Standardabweichung, "
     "dessen Korrelation in der Reichweite auf 0,05 fällt; jeder Startwert ist ein anderes Feld.",
     "Erreur ajoutée aux altitudes du MNT\u202F: un champ aléatoire normal de cet écart type, dont la corrélation "
     "tombe à 0,05 à la portée\u202F; chaque graine donne un autre champ.",
     "Error añadido a las cotas del MDT: un campo aleatorio normal con esta desviación típica, cuya correlación baja a "
     "0,05 en el rango; cada semilla es otro campo."},
    {"Additional stored value that means no elevation, such as 0 around the edge.",
     "Altro valore memorizzato che significa assenza di quota, come 0 lungo il bordo.",
     "Weiterer gespeicherter Wert, der keine Höhe bedeutet, etwa 0 entlang des Rands.",
     "Autre valeur enregistrée signifiant l’absence d’altitude, comme 0 sur le pourtour.",
     "Otro valor almacenado que significa ausencia de cota, como 0 en el borde."},
    {"Outline of the release area: any polygon layer that OGR reads, in its own CRS; FILE|layer=NAME selects a layer.",
     "Perimetro dell’area di distacco: qualsiasi layer di poligoni letto da OGR, nel proprio SR; FILE|layer=NAME "
     "sceglie un layer.",
     "Umriss der Anrissfläche: jede Polygonebene, die OGR liest, in eigenem KBS; FILE|layer=NAME wählt eine Ebene.",
     "Contour de la zone de départ\u202F: toute couche de polygones lue par OGR, dans son propre SCR\u202F; "
     "FILE|layer=NAME choisit une couche.",
     "Contorno del área de inicio: cualquier capa de polígonos que lea OGR, en su propio SRC; FILE|layer=NAME elige "
     "una capa."},
    {"Thickness of the release: one number, a column of the perimeter, a raster, a DTM before minus one after, the DTM "
     "minus a raster of the slip surface's elevation, or minus one fitted to each polygon; structured model: the sum "
     "of two rasters, depths of solids and of fluid.",
     "Spessore del distacco: un numero, una colonna del perimetro, un raster, un DTM prima meno uno dopo, il DTM meno "
     "un raster delle quote della superficie di scivolamento, o meno una adattata a ogni poligono; modello "
     "strutturato: la somma di due raster, profondità dei solidi e del fluido.",
     "Anrissmächtigkeit: eine Zahl, eine Spalte des Umrisses, ein Raster, ein DGM vorher minus eines nachher, das DGM "
     "minus ein Raster der Höhen der Gleitfläche oder minus eine, die jedem Polygon angepasst ist; strukturiertes "
     "Modell: die Summe zweier Raster, Tiefen der Feststoffe und des Fluids.",
     "Épaisseur au départ\u202F: un nombre, une colonne du contour, un raster, un MNT avant moins un après, le MNT "
     "moins un raster des altitudes de la surface de glissement, ou moins une surface ajustée à chaque polygone\u202F; "
     "modèle structuré\u202F: la somme de deux rasters, hauteurs des solides et du fluide.",
     "Espesor del inicio: un número, una columna del perímetro, un ráster, un MDT anterior menos uno posterior, el MDT "
     "menos un ráster de cotas de la superficie de deslizamiento, o menos una ajustada a cada polígono; modelo "
     "estructurado: la suma de dos rásteres, profundidades de los sólidos y del fluido."},
    {"Direction in which the thickness is measured: vertical, or normal to the slope.",
     "Direzione in cui è misurato lo spessore: verticale o normale al versante.",
     "Richtung, in der die Mächtigkeit gemessen ist: vertikal oder senkrecht zum Hang.",
     "Direction de mesure de l’épaisseur\u202F: verticale ou normale à la pente.",
     "Dirección en que se mide el espesor: vertical o normal a la ladera."},
    {"on: the DTM is the ground before the failure, and the bed lies under the release; off: the release lies on top "
     "of the DTM.",
     "on: il DTM è il terreno prima del distacco e il fondo si trova sotto la massa staccata; off: la massa giace "
     "sopra il DTM.",
     "on: das DGM ist das Gelände vor dem Losbrechen, und die Sohle liegt unter der Anrissmasse; off: die Anrissmasse "
     "liegt auf dem DGM.",
     "on\u202F: le MNT est le terrain avant la rupture et le lit se trouve sous la masse au départ\u202F; off\u202F: "
     "cette masse repose sur le MNT.",
     "on: el MDT es el terreno antes de la rotura y el lecho está bajo la masa inicial; off: la masa descansa sobre el "
     "MDT."},
    {"Volume of the release: thicknesses are scaled so that the whole release, or each polygon, has this volume.",
     "Volume del distacco: gli spessori sono scalati in modo che l’intero distacco, o ogni poligono, abbia questo "
     "volume.",
     "Anrissvolumen: die Mächtigkeiten werden so skaliert, dass der ganze Anriss oder jedes Polygon dieses Volumen "
     "hat.",
     "Volume au départ\u202F: les épaisseurs sont mises à l’échelle pour que l’ensemble, ou chaque polygone, ait ce "
     "volume.",
     "Volumen del inicio: los espesores se escalan para que el conjunto, o cada polígono, tenga este volumen."},
    {"Time of failure.", "Momento del distacco.", "Zeitpunkt des Losbrechens.", "Instant de la rupture.",
     "Instante de la rotura."},
    {"Initial speed along the bed.", "Velocità iniziale lungo il fondo.", "Anfangsgeschwindigkeit entlang der Sohle.",
     "Vitesse initiale le long du lit.", "Velocidad inicial a lo largo del lecho."},
    {"Azimuth of the initial velocity, clockwise from grid north.",
     "Azimut della velocità iniziale, in senso orario dal nord di quadrettatura.",
     "Azimut der Anfangsgeschwindigkeit, im Uhrzeigersinn ab Gitternord.",
     "Azimut de la vitesse initiale, dans le sens horaire depuis le nord du quadrillage.",
     "Azimut de la velocidad inicial, en sentido horario desde el norte de cuadrícula."},
    {"Greatest depth of a fitted slip surface below the surface that spans the perimeter; this or release.volume.",
     "Profondità massima di una superficie di scivolamento adattata, sotto la superficie tesa sul perimetro; questa o "
     "release.volume.",
     "Größte Tiefe einer angepassten Gleitfläche unter der Fläche, die den Umriss überspannt; diese oder "
     "release.volume.",
     "Profondeur maximale d’une surface de glissement ajustée, sous la surface tendue sur le contour\u202F; celle-ci "
     "ou release.volume.",
     "Profundidad máxima de una superficie de deslizamiento ajustada bajo la superficie que cubre el perímetro; esta o "
     "release.volume."},
    {"Shape of a fitted slip surface; auto: ellipsoid if the whole perimeter is visible from its centroid, otherwise "
     "sloping local base level.",
     "Forma di una superficie di scivolamento adattata; auto: ellissoide se tutto il perimetro è visibile dal suo "
     "baricentro, altrimenti sloping local base level.",
     "Form einer angepassten Gleitfläche; auto: Ellipsoid, wenn der ganze Umriss vom Schwerpunkt aus sichtbar ist, "
     "sonst Sloping Local Base Level.",
     "Forme d’une surface de glissement ajustée\u202F; auto\u202F: ellipsoïde si tout le contour est visible depuis "
     "son centre de gravité, sinon sloping local base level.",
     "Forma de una superficie de deslizamiento ajustada; auto: elipsoide si todo el perímetro es visible desde su "
     "centroide, si no sloping local base level."},
    {"Layer to read if the file contains several.", "Layer da leggere se il file ne contiene più d’uno.",
     "Zu lesende Ebene, wenn die Datei mehrere enthält.", "Couche à lire si le fichier en contient plusieurs.",
     "Capa que se lee si el archivo contiene varias."},
    {"Condition on the attributes, as in SQL: kind = 'scar' AND year > 2000.",
     "Condizione sugli attributi, come in SQL: kind = 'scar' AND year > 2000.",
     "Bedingung an die Attribute, wie in SQL: kind = 'scar' AND year > 2000.",
     "Condition sur les attributs, comme en SQL\u202F: kind = 'scar' AND year > 2000.",
     "Condición sobre los atributos, como en SQL: kind = 'scar' AND year > 2000."},
    {"CRS, if the file names none or a wrong one.", "SR, se il file non ne indica alcuno o ne indica uno errato.",
     "KBS, wenn die Datei keines oder ein falsches nennt.",
     "SCR, si le fichier n’en indique aucun ou en indique un faux.",
     "SRC, si el archivo no indica ninguno o indica uno erróneo."},
    {"CRS of the thickness rasters, if they name none or a wrong one.",
     "SR dei raster di spessore, se non ne indicano alcuno o ne indicano uno errato.",
     "KBS der Raster der Mächtigkeit, wenn sie keines oder ein falsches nennen.",
     "SCR des rasters d’épaisseur, s’ils n’en indiquent aucun ou en indiquent un faux.",
     "SRC de los rásteres de espesor, si no indican ninguno o indican uno erróneo."},
    {"Lines of inflow: any layer that OGR reads, in its own CRS.",
     "Linee di afflusso: qualsiasi layer letto da OGR, nel proprio SR.",
     "Zuflusslinien: jede Ebene, die OGR liest, in eigenem KBS.",
     "Lignes d’afflux\u202F: toute couche lue par OGR, dans son propre SCR.",
     "Líneas de entrada: cualquier capa que lea OGR, en su propio SRC."},
    {"CSV with the columns time, discharge or volume, and velocity; attribute:NAME: a column of the lines with a file "
     "for each.",
     "CSV con le colonne time, discharge o volume, e velocity; attribute:NAME: una colonna delle linee con un file per "
     "ciascuna.",
     "CSV mit den Spalten time, discharge oder volume und velocity; attribute:NAME: eine Spalte der Linien mit einer "
     "Datei je Linie.",
     "CSV avec les colonnes time, discharge ou volume, et velocity\u202F; attribute:NAME\u202F: une colonne des lignes "
     "avec un fichier pour chacune.",
     "CSV con las columnas time, discharge o volume, y velocity; attribute:NAME: una columna de las líneas con un "
     "archivo para cada una."},
    {"Azimuth of the inflow, clockwise from grid north.",
     "Azimut dell’afflusso, in senso orario dal nord di quadrettatura.",
     "Azimut des Zuflusses, im Uhrzeigersinn ab Gitternord.",
     "Azimut de l’afflux, dans le sens horaire depuis le nord du quadrillage.",
     "Azimut de la entrada, en sentido horario desde el norte de cuadrícula."},
});

}  // namespace

std::span<const WordRow> key_words_site() {
    return k_key_words_site;
}

}  // namespace frana
