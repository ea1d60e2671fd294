// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/words/word_row.h"

namespace frana {
namespace {

constexpr auto k_key_words_pictures = std::to_array<WordRow>({
    {"Size of maps, views and charts, in pixels or as a page.",
     "Dimensione di mappe, vedute e grafici, in pixel o come pagina.",
     "Größe von Karten, Ansichten und Diagrammen, in Pixeln oder als Seite.",
     "Taille des cartes, vues et graphiques, en pixels ou en page.",
     "Tamaño de mapas, vistas y gráficos, en píxeles o como página."},
    {"File formats of each map: picture, geospatial PDF page, SVG drawing, GeoTIFF of the area inside the frame.",
     "Formati di ogni mappa: immagine, pagina PDF georeferenziata, disegno SVG, GeoTIFF dell’area dentro la cornice.",
     "Dateiformate jeder Karte: Bild, georeferenzierte PDF-Seite, SVG-Zeichnung, GeoTIFF der Fläche innerhalb des "
     "Rahmens.",
     "Formats de chaque carte\u202F: image, page PDF géoréférencée, dessin SVG, GeoTIFF de la surface à l’intérieur du "
     "cadre.",
     "Formatos de cada mapa: imagen, página PDF georreferenciada, dibujo SVG, GeoTIFF del área dentro del marco."},
    {"Colours in classes, or continuous.", "Colori in classi o continui.", "Farben in Klassen oder stufenlos.",
     "Couleurs en classes ou continues.", "Colores en clases o continuos."},
    {"Orthophoto or topographic raster (bytes) under maps and views, in its own CRS.",
     "Ortofoto o raster topografico (byte) sotto mappe e vedute, nel proprio SR.",
     "Orthofoto oder topographisches Raster (Bytes) unter Karten und Ansichten, in eigenem KBS.",
     "Orthophoto ou raster topographique (octets) sous les cartes et vues, dans son propre SCR.",
     "Ortofoto o ráster topográfico (bytes) bajo mapas y vistas, en su propio SRC."},
    {"Owner and licence of output.map-background, at the foot of maps and views.",
     "Proprietario e licenza di output.map-background, al piede di mappe e vedute.",
     "Eigentümer und Lizenz von output.map-background, am Fuß von Karten und Ansichten.",
     "Propriétaire et licence de output.map-background, au pied des cartes et vues.",
     "Propietario y licencia de output.map-background, al pie de mapas y vistas."},
    {"Scale of maps on paper sizes (A4, A3): 5000 for 1 : 5000.",
     "Scala delle mappe su formati carta (A4, A3): 5000 per 1 : 5000.",
     "Maßstab der Karten auf Papierformaten (A4, A3): 5000 für 1 : 5000.",
     "Échelle des cartes sur formats papier (A4, A3)\u202F: 5000 pour 1\u202F: 5000.",
     "Escala de los mapas en tamaños de papel (A4, A3): 5000 para 1 : 5000."},
    {"Author, in the title block of maps.", "Autore, nel cartiglio delle mappe.",
     "Verfasser, im Schriftfeld der Karten.", "Auteur, dans le cartouche des cartes.",
     "Autor, en el cajetín de los mapas."},
    {"Organisation, in the title block of maps.", "Ente, nel cartiglio delle mappe.",
     "Organisation, im Schriftfeld der Karten.", "Organisme, dans le cartouche des cartes.",
     "Organización, en el cajetín de los mapas."},
    {"Logo in the title block of maps: a PNG or JPEG file.", "Logo nel cartiglio delle mappe: un file PNG o JPEG.",
     "Logo im Schriftfeld der Karten: eine PNG- oder JPEG-Datei.",
     "Logo dans le cartouche des cartes\u202F: un fichier PNG ou JPEG.",
     "Logotipo en el cajetín de los mapas: un archivo PNG o JPEG."},
    {"Date in the title block of maps; none: no date.", "Data nel cartiglio delle mappe; none: nessuna data.",
     "Datum im Schriftfeld der Karten; none: kein Datum.",
     "Date dans le cartouche des cartes\u202F; none\u202F: pas de date.",
     "Fecha en el cajetín de los mapas; none: sin fecha."},
    {"Sources of the data and author, at the foot of every picture.",
     "Fonti dei dati e autore, al piede di ogni immagine.", "Quellen der Daten und Verfasser, am Fuß jedes Bilds.",
     "Sources des données et auteur, au pied de chaque image.", "Fuentes de los datos y autor, al pie de cada imagen."},
    {"Language of maps, charts, legends and the report; auto: that of the locale (LC_ALL, LC_MESSAGES, LANG), English "
     "if it is none of these.",
     "Lingua di mappe, grafici, legende e rapporto; auto: quella della localizzazione (LC_ALL, LC_MESSAGES, LANG), "
     "inglese se non è una di queste.",
     "Sprache von Karten, Diagrammen, Legenden und Bericht; auto: die der Spracheinstellung (LC_ALL, LC_MESSAGES, "
     "LANG), Englisch, wenn es keine dieser Sprachen ist.",
     "Langue des cartes, graphiques, légendes et du rapport\u202F; auto\u202F: celle des paramètres régionaux (LC_ALL, "
     "LC_MESSAGES, LANG), l’anglais si ce n’est aucune de celles-ci.",
     "Idioma de mapas, gráficos, leyendas e informe; auto: el de la configuración regional (LC_ALL, LC_MESSAGES, "
     "LANG), inglés si no es ninguno de estos."},
    {"Title of the maps.", "Titolo delle mappe.", "Titel der Karten.", "Titre des cartes.", "Título de los mapas."},
    {"Vertical exaggeration of 3-D views.", "Esagerazione verticale delle vedute 3D.", "Überhöhung der 3D-Ansichten.",
     "Exagération verticale des vues 3D.", "Exageración vertical de las vistas 3D."},
    {"Background of 3-D views: a blue sky, or white.", "Sfondo delle vedute 3D: un cielo azzurro, o bianco.",
     "Hintergrund der 3D-Ansichten: blauer Himmel oder weiß.", "Fond des vues 3D\u202F: un ciel bleu, ou blanc.",
     "Fondo de las vistas 3D: un cielo azul, o blanco."},
    {"Camera of 3-D views: viewing direction [degrees from grid north], downward angle [degrees], zoom.",
     "Camera delle vedute 3D: direzione di vista [gradi dal nord di quadrettatura], angolo verso il basso [gradi], "
     "zoom.",
     "Kamera der 3D-Ansichten: Blickrichtung [Grad ab Gitternord], Winkel nach unten [Grad], Zoom.",
     "Caméra des vues 3D\u202F: direction de vue [degrés depuis le nord du quadrillage], angle vers le bas [degrés], "
     "zoom.",
     "Cámara de las vistas 3D: dirección de vista [grados desde el norte de cuadrícula], ángulo hacia abajo [grados], "
     "zoom."},
    {"Draw charts, unless maps are off: profiles, time series, scores over the threshold.",
     "Disegnare grafici, salvo che le mappe siano off: profili, serie temporali, punteggi secondo la soglia.",
     "Diagramme zeichnen, außer wenn die Karten off sind: Längenprofile, Zeitreihen, Bewertung über dem Schwellenwert.",
     "Dessiner des graphiques, sauf si les cartes sont off\u202F: profils, séries temporelles, scores selon le seuil.",
     "Dibujar gráficos, salvo que los mapas estén en off: perfiles, series temporales, puntuaciones según el umbral."},
    {"Classes of colours on maps, in films and in GIS styles: fixed, so that results can be compared, or round steps "
     "up to the greatest value of each raster.",
     "Classi di colore su mappe, filmati e stili GIS: fixed, perché i risultati siano confrontabili, o passi tondi "
     "fino al valore massimo di ogni raster.",
     "Farbklassen auf Karten, in Filmen und GIS-Stilen: fixed, damit Ergebnisse vergleichbar sind, oder runde Stufen "
     "bis zum größten Wert jedes Rasters.",
     "Classes de couleurs sur les cartes, les films et dans les styles SIG\u202F: fixed, pour que les résultats soient "
     "comparables, ou pas ronds jusqu’à la valeur maximale de chaque raster.",
     "Clases de color en mapas, películas y estilos SIG: fixed, para poder comparar resultados, o pasos redondos hasta "
     "el valor máximo de cada ráster."},
    {"Bounds of the fixed classes of depths and thicknesses; the last class is open.",
     "Limiti delle classi fisse di profondità e spessori; l’ultima classe è aperta.",
     "Grenzen der festen Klassen von Tiefen und Mächtigkeiten; die letzte Klasse ist offen.",
     "Bornes des classes fixes de hauteurs et d’épaisseurs\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de profundidades y espesores; la última clase es abierta."},
    {"Bounds of the fixed classes of speeds; the last class is open.",
     "Limiti delle classi fisse di velocità; l’ultima classe è aperta.",
     "Grenzen der festen Klassen von Geschwindigkeiten; die letzte Klasse ist offen.",
     "Bornes des classes fixes de vitesses\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de velocidades; la última clase es abierta."},
    {"Bounds of the fixed classes of dynamic pressures; the last class is open.",
     "Limiti delle classi fisse di pressione dinamica; l’ultima classe è aperta.",
     "Grenzen der festen Klassen des dynamischen Drucks; die letzte Klasse ist offen.",
     "Bornes des classes fixes de pression dynamique\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de presión dinámica; la última clase es abierta."},
    {"Bounds of the fixed classes of times of arrival; the last class is open.",
     "Limiti delle classi fisse dei tempi di arrivo; l’ultima classe è aperta.",
     "Grenzen der festen Klassen der Ankunftszeiten; die letzte Klasse ist offen.",
     "Bornes des classes fixes de temps d’arrivée\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de tiempos de llegada; la última clase es abierta."},
    {"Bounds of the fixed classes of products of depth and speed; the last class is open.",
     "Limiti delle classi fisse dei prodotti di profondità e velocità; l’ultima classe è aperta.",
     "Grenzen der festen Klassen der Produkte aus Tiefe und Geschwindigkeit; die letzte Klasse ist offen.",
     "Bornes des classes fixes des produits de la hauteur et de la vitesse\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de los productos de profundidad y velocidad; la última clase es abierta."},
    {"Bounds of the fixed classes of energy heads; the last class is open.",
     "Limiti delle classi fisse dei carichi totali (altezza di energia); l’ultima classe è aperta.",
     "Grenzen der festen Klassen der Energiehöhen; die letzte Klasse ist offen.",
     "Bornes des classes fixes des charges hydrauliques\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de alturas de energía; la última clase es abierta."},
    {"Bounds of the fixed classes of strains; the last class is open.",
     "Limiti delle classi fisse di deformazione; l’ultima classe è aperta.",
     "Grenzen der festen Klassen der Dehnungen; die letzte Klasse ist offen.",
     "Bornes des classes fixes de déformation\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas de deformación; la última clase es abierta."},
    {"Bounds of the fixed classes of estimated errors of the depth; the last class is open.",
     "Limiti delle classi fisse dell’errore stimato di profondità; l’ultima classe è aperta.",
     "Grenzen der festen Klassen des geschätzten Fehlers der Tiefe; die letzte Klasse ist offen.",
     "Bornes des classes fixes d’erreur estimée de la hauteur\u202F; la dernière classe est ouverte.",
     "Límites de las clases fijas del error estimado de la profundidad; la última clase es abierta."},
});

}  // namespace

std::span<const WordRow> key_words_pictures() {
    return k_key_words_pictures;
}

}  // namespace frana
