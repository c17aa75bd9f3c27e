// Tables of points as people have them: each is read right, or refused with the reason.
//
// Covers file_kind, field_kind, point_text, row_parser, table_layout, table_sample, text_encoding
// and text_lines.
#include <algorithm>
#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/point_file.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

/// UTF-16 of ASCII text.
std::string utf16(std::string_view ascii, bool little_endian, bool mark = true) {
  std::string text = !mark ? "" : little_endian ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) {
    const char unit[] = {c, '\0'};
    text.push_back(unit[little_endian ? 0 : 1]);
    text.push_back(unit[little_endian ? 1 : 0]);
  }
  return text;
}

std::string replaced(std::string text, char from, const std::string& to) {
  std::string result;
  for (const char c : text) c == from ? void(result += to) : result.push_back(c);
  return result;
}

class PointDialects : public testing::Test {
 protected:
  PointTable read(std::string_view content, std::string_view columns = "") const {
    return read_point_table(directory_.file("points.csv", content),
                            {parse_column_choice("--columns", columns)});
  }
  std::string error(std::string_view content, std::string_view columns = "") const {
    try {
      return message_of<Error>([&] { read(content, columns); });
    } catch (const std::runtime_error& none) {
      return none.what();
    }
  }

  TemporaryDirectory directory_;
};

const std::vector<Point> kPlane = {{600000.25, 200000.5}, {600010, 200001.5}, {600005.75, 200012}};
const std::vector<double> kHeights = {451.5, 452.25, 449};

struct Understood {
  const char* from;
  std::string content;
  const char* columns;  ///< that are taken, as numbers
};

std::string numbers_of(const TakenColumns& columns) {
  return std::to_string(columns.x.number) + " " + std::to_string(columns.y.number) +
         (columns.z ? " " + std::to_string(columns.z->number) : "");
}

const std::string kCsv =
    "x,y,z\n600000.25,200000.5,451.5\n600010,200001.5,452.25\n"
    "600005.75,200012,449\n";

std::vector<Understood> understood() {
  return {
      {"pandas with its index",
       ",x,y,z\n0,600000.25,200000.5,451.5\n1,600010.0,200001.5,452.25\n2,600005.75,200012.0,449."
       "0\n",
       "2 3 4"},
      {"pandas, all quoted",
       "\"x\",\"y\",\"z\"\n\"600000.25\",\"200000.5\",\"451.5\"\n\"600010\",\"200001.5\",\"452."
       "25\"\n"
       "\"600005.75\",\"200012\",\"449\"\n",
       "1 2 3"},
      {"R write.table",
       "\"x\" \"y\" \"z\"\n\"1\" 600000.25 200000.5 451.5\n\"2\" 600010 200001.5 452.25\n"
       "\"3\" 600005.75 200012 449\n",
       "2 3 4"},
      {"R write.table without quotes",
       "x y z\n1 600000.25 200000.5 451.5\n2 600010 200001.5 452.25\n3 600005.75 200012 449\n",
       "2 3 4"},
      {"R with names of rows",
       "\"x\",\"y\",\"z\"\n\"a\",600000.25,200000.5,451.5\n\"b\",600010,200001.5,452.25\n"
       "\"c\",600005.75,200012,449\n",
       "2 3 4"},
      {"R write.csv",
       "\"\",\"x\",\"y\",\"z\"\n\"1\",600000.25,200000.5,451.5\n\"2\",600010,200001.5,452.25\n"
       "\"3\",600005.75,200012,449\n",
       "2 3 4"},
      {"R write.csv2",
       "\"\";\"x\";\"y\";\"z\"\n\"1\";600000,25;200000,5;451,5\n\"2\";600010;200001,5;452,25\n"
       "\"3\";600005,75;200012;449\n",
       "2 3 4"},
      {"German Excel",
       "Punktnummer;Rechtswert;Hochwert;H\xC3\xB6he\r\n1;600000,25;200000,5;451,5\r\n"
       "2;600010;200001,5;452,25\r\n3;600005,75;200012;449\r\n",
       "2 3 4"},
      {"German Excel in Windows-1252",
       "Nr;Ost;Nord;H\xF6he \xFC. NN [m]\r\n1;600000,25;200000,5;451,5\r\n"
       "2;600010;200001,5;452,25\r\n3;600005,75;200012;449\r\n",
       "2 3 4"},
      {"Excel that says its separator",
       "sep=;\r\nx;y;z\r\n600000,25;200000,5;451,5\r\n600010;200001,5;452,25\r\n"
       "600005,75;200012;449\r\n",
       "1 2 3"},
      {"Excel that says its separator in quotes",
       "\"sep=|\"\nx|y|z\n600000.25|200000.5|451.5\n600010|200001.5|452.25\n600005.75|200012|449\n",
       "1 2 3"},
      {"Excel, Unicode text",
       utf16("x\ty\tz\r\n600000.25\t200000.5\t451.5\r\n600010\t200001.5\t452.25\r\n"
             "600005.75\t200012\t449\r\n",
             true),
       "1 2 3"},
      {"UTF-16, big end first", utf16(kCsv, false), "1 2 3"},
      {"UTF-8 with a mark", "\xEF\xBB\xBF" + kCsv, "1 2 3"},
      {"an old Mac", replaced(kCsv, '\n', "\r"), "1 2 3"},
      {"line ends converted twice", replaced(kCsv, '\n', "\r\r\n"), "1 2 3"},
      {"French Excel",
       "Matricule;Abscisse est;Est;Nord;Altitude\n1;7;600000,25;200000,5;451,5\n"
       "2;7;600010;200001,5;452,25\n3;7;600005,75;200012;449\n",
       "3 4 5"},
      {"the first row happens to be whole",
       "Est;Nord;Cote\n600000,25;200000,5;451,5\n600010;200001,5;452,25\n600005,75;200012;449\n",
       "1 2 3"},
      {"decimal commas between tabs",
       "600000,25\t200000,5\t451,5\n600010\t200001,5\t452,25\n600005,75\t200012\t449\n", "1 2 3"},
      {"decimal commas between blanks",
       "  600000,25   200000,5   451,5\n  600010,00   200001,5   452,25\n"
       "  600005,75   200012   449\n",
       "1 2 3"},
      {"decimal commas between bars",
       "600000,25|200000,5|451,5\n600010|200001,5|452,25\n600005,75|200012|449\n", "1 2 3"},
      {"PENZD by name",
       "Point,Easting,Northing,Elevation,Description\n1,600000.25,200000.5,451.5,EP\n"
       "2,600010,200001.5,452.25,\n3,600005.75,200012,449,\"GND, wet\"\n",
       "2 3 4"},
      {"PNEZD by name",
       "P,N,E,Z,D\n101,200000.5,600000.25,451.5,GND\n102,200001.5,600010,452.25,GND, wet\n"
       "103,200012,600005.75,449\n",
       "3 2 4"},
      {"Civil 3D, names in one comment",
       "# Point No,Northing,Easting,Point Elevation,Raw Description\n"
       "1,200000.5,600000.25,451.5,TREE\n2,200001.5,600010,452.25,TREE\n3,200012,600005.75,449,X\n",
       "3 2 4"},
      {"Trimble Access",
       "Name;North;East;Elevation;Code\nA1;200000.5;600000.25;451.5;BK\nA2;200001.5;600010;452.25;"
       "BK\n"
       "A3;200012;600005.75;449;BK\n",
       "3 2 4"},
      {"Leica Infinity",
       "Point Id\tEasting [m]\tNorthing [m]\tOrthometric Height [m]\tCode\n"
       "GPS1\t600000.25\t200000.5\t451.5\t\nGPS2\t600010\t200001.5\t452.25\t\n"
       "GPS3\t600005.75\t200012\t449\t\n",
       "2 3 4"},
      {"Emlid",
       "Name,Longitude,Latitude,Ellipsoidal height,Easting,Northing,Antenna height\n"
       "1,7.4,46.9,451.5,600000.25,200000.5,1.8\n2,7.4,46.9,452.25,600010,200001.5,1.8\n"
       "3,7.4,46.9,449,600005.75,200012,1.8\n",
       "5 6 4"},
      {"degrees",
       "id,latitude_wgs84,longitude_wgs84,height_msl\n7,200000.5,600000.25,451.5\n"
       "9,200001.5,600010,452.25\n8,200012,600005.75,449\n",
       "3 2 4"},
      {"a comment as a header",
       "# lat lon z\n200000.5 600000.25 451.5\n200001.5 600010 452.25\n200012 600005.75 449\n",
       "2 1 3"},
      {"a comment with commas over blanks",
       "# x, y, z\n600000.25 200000.5 451.5\n600010 200001.5 452.25\n600005.75 200012 449\n",
       "1 2 3"},
      {"CloudCompare",
       "//X Y Z R G B\n600000.25 200000.5 451.5 10 20 30\n600010 200001.5 452.25 11 21 31\n"
       "600005.75 200012 449 12 22 32\n",
       "1 2 3"},
      {"CloudCompare, colours first",
       "// R G B X Y Z\n10 20 30 600000.25 200000.5 451.5\n11 21 31 600010 200001.5 452.25\n"
       "12 22 32 600005.75 200012 449\n",
       "4 5 6"},
      {"PTS",
       "3\n600000.25 200000.5 451.5 -1200 10 20 30\n600010 200001.5 452.25 -1100 11 21 31\n"
       "600005.75 200012 449 -900 12 22 32\n",
       "1 2 3"},
      {"las2txt",
       "600000.25 200000.5 451.5 17 2\n600010.0 200001.5 452.25 18 2\n"
       "600005.75 200012.0 449.0 19 2\n",
       "1 2 3"},
      {"MATLAB's comments",
       "% exported\n% x y z\n600000.25 200000.5 451.5\n600010 200001.5 452.25\n600005.75 200012 "
       "449\n",
       "1 2 3"},
      {"GMT",
       "> segment 1\n600000.25\t200000.5\t451.5\n! and 2\n600010\t200001.5\t452.25\n>\n"
       "600005.75\t200012\t449\n",
       "1 2 3"},
      {"Fortran",
       " 0.60000025D+06  0.2000005D+06  0.4515D+03\n 0.60001D+06  0.2000015D+06  4.5225d2\n"
       " 6.0000575D5  2.00012D5  4.49D2\n",
       "1 2 3"},
      {"a row of units",
       "East;North;Height\nm;m;m\n600000.25;200000.5;451.5\n600010;200001.5;452.25\n"
       "600005.75;200012;449\n",
       "1 2 3"},
      {"a row of units in brackets",
       "lat,lon,alt\n[deg],[deg],[m]\n200000.5,600000.25,451.5\n200001.5,600010,452.25\n"
       "200012,600005.75,449\n",
       "2 1 3"},
      {"QGIS with geometry as text",
       "WKT,id\n\"POINT Z (600000.25 200000.5 451.5)\",1\n\"POINT Z (600010 200001.5 452.25)\",2\n"
       "POINTZ(600005.75 200012 449),3\n",
       "1 1 1"},
      {"geometry as text, heights beside it",
       "elev;geom\n451.5;POINT (600000.25 200000.5)\n452.25;SRID=2056;POINT(600010 200001.5)\n"
       "449;POINT M (600005.75 200012 7)\n",
       "2 2 1"},
      {"nothing but geometry as text",
       "POINT Z (600000.25 200000.5 451.5)\nPOINT Z (600010 200001.5 452.25)\n"
       "POINT ZM (600005.75 200012 449 1)\n",
       "1 1 1"},
      {"ArcGIS",
       "OBJECTID,POINT_X,POINT_Y,POINT_Z\n1,600000.25,200000.5,451.5\n"
       "2,600010,200001.5,452.25\n3,600005.75,200012,449\n",
       "2 3 4"},
      {"QGIS, coordinates as attributes",
       "fid,name,xcoord,ycoord,z_mean,elev\n1,a,600000.25,200000.5,0,451.5\n"
       "2,b,600010,200001.5,0,452.25\n3,c,600005.75,200012,0,449\n",
       "3 4 6"},
      {"Darwin core",
       "decimalLatitude,decimalLongitude,elevationInMeters\n"
       "200000.5,600000.25,451.5\n200001.5,600010,452.25\n200012,600005.75,449\n",
       "2 1 3"},
      {"Spanish",
       "Punto;Este;Norte;Cota\nP1;600000,25;200000,5;451,5\nP2;600010;200001,5;452,25\n"
       "P3;600005,75;200012;449\n",
       "2 3 4"},
      {"Italian",
       "nome,est,nord,quota\na,600000.25,200000.5,451.5\nb,600010,200001.5,452.25\n"
       "c,600005.75,200012,449\n",
       "2 3 4"},
      {"Portuguese",
       "ponto\tnorte\tleste\televa\xC3\xA7\xC3\xA3o\n1\t200000.5\t600000.25\t451.5\n"
       "2\t200001.5\t600010\t452.25\n3\t200012\t600005.75\t449\n",
       "3 2 4"},
      {"Dutch",
       "nr;oost;noord;hoogte NAP\n1;600000,25;200000,5;451,5\n2;600010;200001,5;452,25\n"
       "3;600005,75;200012;449\n",
       "2 3 4"},
      {"Swedish",
       "Namn;Nord;\xC3\x96st;H\xC3\xB6jd\n1;200000,5;600000,25;451,5\n"
       "2;200001,5;600010;452,25\n3;200012;600005,75;449\n",
       "3 2 4"},
      {"German degrees",
       "Breite;L\xC3\xA4nge;H\xC3\xB6he\n200000,5;600000,25;451,5\n200001,5;600010;452,25\n"
       "200012;600005,75;449\n",
       "2 1 3"},
      {"swisstopo",
       "E_LV95,N_LV95,H_LN02\n600000.25,200000.5,451.5\n600010,200001.5,452.25\n"
       "600005.75,200012,449\n",
       "1 2 3"},
      {"separators at the ends of rows",
       "x;y;z\n600000.25;200000.5;451.5;\n600010;200001.5;452.25;;\n600005.75;200012;449\n",
       "1 2 3"},
      {"separators at the ends of all rows",
       "600000.25,200000.5,451.5,\n600010,200001.5,452.25,\n600005.75,200012,449,\n", "1 2 3"},
      {"remarks with blanks",
       "x y z remark\n600000.25 200000.5 451.5 edge of road\n600010 200001.5 452.25\n"
       "600005.75 200012 449 tree\n",
       "1 2 3"},
      {"blanks after commas",
       "x, y, z\n600000.25, 200000.5, 451.5\n600010, 200001.5, 452.25\n600005.75, 200012, 449\n",
       "1 2 3"},
      {"a header with another separator",
       "x,y,z\n600000.25 200000.5 451.5\n600010 200001.5 452.25\n600005.75 200012 449\n", "1 2 3"},
      {"prose in comments",
       "# Survey of x and y by the municipality in 2019, heights in metres\n"
       "600000.25 200000.5 451.5\n600010 200001.5 452.25\n600005.75 200012 449\n",
       "1 2 3"},
      {"NMEA-like rest of the line",
       "X,Y,Z,Time,Fix\n600000.25,200000.5,451.5,12:30:01.5,RTK\n"
       "600010,200001.5,452.25,12:30:02.5,RTK\n600005.75,200012,449,12:30:03.5,RTK\n",
       "1 2 3"},
      {"units behind the names",
       "X [m] Y [m] Z [m]\n600000.25 200000.5 451.5\n600010 200001.5 452.25\n"
       "600005.75 200012 449\n",
       "1 2 3"},
      {"a header behind the number of rows",
       "3\nX Y Z I\n600000.25 200000.5 451.5 1\n600010 200001.5 452.25 2\n"
       "600005.75 200012 449 3\n",
       "1 2 3"},
      {"words between numbers",
       "Code;X;Y;Z;Bemerkung\n12a;600000.25;200000.5;451.5;6\" Rohr\n12b;600010;200001.5;452.25;-\n"
       "12c;600005.75;200012;449;12\n",
       "2 3 4"},
  };
}

TEST_F(PointDialects, are_read_right) {
  for (const Understood& c : understood()) {
    SCOPED_TRACE(c.from);
    try {
      const PointTable table = read(c.content);
      EXPECT_EQ(table.points.xy, kPlane);
      EXPECT_EQ(table.points.z, kHeights);
      EXPECT_EQ(numbers_of(table.columns), c.columns);
      EXPECT_EQ(table.warnings, std::vector<std::string>());
    } catch (const Error& refused) {
      ADD_FAILURE() << refused.what();
    }
  }
}

struct Refused {
  std::string content;
  const char* place;
  const char* reason;
};

void expect_refused(const std::string& message, const Refused& c) {
  EXPECT_NE(message.find(c.place), std::string::npos) << c.content << "\n" << message;
  EXPECT_NE(message.find(c.reason), std::string::npos) << c.content << "\n" << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST_F(PointDialects, rows_that_do_not_fit_are_refused) {
  const Refused cases[] = {
      {"x,y,z\n600000,25,200000,5,451,5\n", "line 2:", "6 values and the header has 3"},
      {"x,y,z\n600000,25,200000,5,451,5\n", "line 2:", "semicolons"},
      {"x,y,z\n1,2,3\n4,5,6,7\n", "line 3:", "4 values and the header has 3"},
      {"x,y,z\n5,600000,200000,451\n9,600000,200000,452\n", "line 2:", "4 values"},
      {"x y z\n600000.5 200000.5 451.5 17\n", "line 2:", "4 values"},
      {"id,x,y,z,code\n1,2,3,4,5\n2,3,4,5\n", "line 3:", "4 values and the header has 5"},
      {"id,x,y,z\n1,2,3,4\n2,3,4\n", "line 3:", "no value for z"},
      {"1,2,3.5\n4,5,6,7\n", "line 2:", "4 values and the first row has 3"},
      {"1.5,2,3,4\n4.5,5,6\n", "line 2:", "3 values and the first row has 4"},
      {"x,y,z,remark\n1,2,3,a\n600000,25,200000,5,451,5\n", "line 3:", "6 values"},
      {"a title\nx,y,z\n1,2,3\n", "line 1:", "remove it, or start it with #"},
      {"Export 1\n1,2,3\n4,5,6\n", "line 1:", "remove it"},
      {"# lat lon z\n1 2 3 4\n5 6 7 8\n", "line 1:", "do not fit the 4 columns"},
      {"1,2,3\n4,5,6\r7,8,9\n", "line 2:", "carriage return"},
      {"5\n1 2 3\n4 5 6\n", "points.csv:", "there are 5 points, but there are 2"},
      {"2\n1 2 3\n4 5 6\n2\n1 2 3\n4 5 6\n", "line 4:", "no value for y"},
      {"x,y,z\n1,2,3\nx,y,z\n4,5,6\n", "line 3:", "'x' for x"},
      {"WKT,id\nPOINT Z (1 2 3),1\nPOINT (1 2),2\n", "line 3:", "lacks a height"},
      {"WKT,id\nPOINT (1 2),1\n\"LINESTRING (1 2, 3 4)\",2\n", "line 3:", "no POINT"},
      {"WKT,id\nPOINT (1 2),1\nPOINT EMPTY,2\n", "line 3:", "two to four numbers"},
  };
  for (const Refused& c : cases) expect_refused(error(c.content), c);
}

TEST_F(PointDialects, a_first_row_of_data_does_not_vanish) {
  const Refused cases[] = {
      {"NA,NA,NA\n1,2,3\n4,5,6\n", "line 1:", "x is 'NA'"},
      {"-;-;-\n1;2;3\n", "line 1:", "x is '-'"},
      {"*** *** ***\n1 2 3\n", "line 1:", "x is '***'"},
      {"N47.5,E8.5,451m\n1,2,3\n", "line 1:", "'N47.5' in column 1 is no number"},
      {"12:30,12:31,12:32\n1,2,3\n", "line 1:", "'12:30'"},
      {"none;none;none\n1;2;3\n", "line 1:", "x is 'none'"},
      {"1e999 2e999 3e999\n1 2 3\n", "line 1:", "not a finite number"},
      {"error,error,error\n1,2,3\n", "line 1:", "'error' in column 1 is no number"},
      {"1,2,3 m\n4,5,6 m\n", "line 1:", "'3 m'"},
  };
  for (const Refused& c : cases) expect_refused(error(c.content), c);

  PointSet points = read("2600000,25;1200000,5;451,5\n2600001;1200001;452\n").points;
  EXPECT_EQ(points.xy, (std::vector<Point>{{2600000.25, 1200000.5}, {2600001, 1200001}}));
  EXPECT_EQ(points.z, (std::vector<double>{451.5, 452}));
  points = read("0.0D0 0.0D0 1.0D0\n1 2 3\n").points;
  EXPECT_EQ(points.xy, (std::vector<Point>{{0, 0}, {1, 2}}));
  EXPECT_EQ(points.z, (std::vector<double>{1, 3}));
  points = read("1;2;3\n4;5,5;6\n").points;
  EXPECT_EQ(points.xy, (std::vector<Point>{{1, 2}, {4, 5.5}}));
}

TEST_F(PointDialects, what_a_comma_means_is_not_guessed) {
  const Refused cases[] = {
      {"1;2.5;3\n4;5,5;6\n", "line 1:", "'2.5' for y has a decimal point"},
      {"1,5;2;3\n4;5.5;6\n", "line 2:", "'5.5' for y has a decimal point"},
      {"x;y;z\n1.234,5;2;3\n", "line 2:", "'1.234,5'"},
      {"x;y;z\n1,234.5;2;3\n", "line 2:", "'1,234.5'"},
      {"x;y;z\n1,234,567;2;3\n", "line 2:", "'1,234,567'"},
      {"x,y,z\n\"600,000\",\"200,000\",451\n", "line 2:", "divide thousands"},
      {"600000,25,200000,5,451,5\n600001,25,200000,5,451,5\n", "line 1:", "decimal signs"},
      {"600000,25,200000,5\n600001,25,200001,5\n", "line 1:", "decimal signs"},
      {"600,000;200,000;451\n601,000;200,000;452\n", "points.csv", "divide thousands"},
  };
  for (const Refused& c : cases) expect_refused(error(c.content), c);
}

TEST_F(PointDialects, names_are_understood_or_refused) {
  const Refused cases[] = {
      {"id,first,second,third\n1,2,3,4\n", "line 1:", "--columns"},
      {"id,first,second\n1,2,3\n", "line 1:", "--columns"},
      {"first,second,third,fourth\n1,2,3,4\n", "line 1:", "do not say which columns"},
      {"Nr,Ost,Hoehe\n1,2,3\n", "line 1:", "do not name both x and y"},
      {"x,height\n1,2\n", "line 1:", "name both x and y"},
      {"lat_deg,lat_min,lon_deg,lon_min,z\n1,2,3,4,5\n", "line 1:", "could be any"},
      {"lat_d,lat_m,lat_s,lon_d,lon_m,lon_s,z\n1,2,3,4,5,6,7\n", "line 1:", "could be any"},
      {"lat,N/S,lon,E/W,alt\n47,N,8,W,5\n", "line 1:", "could be any"},
      {"easting_lv95,northing_lv95,easting_utm,northing_utm,z\n1,2,3,4,5\n",
       "line 1:", "'easting_lv95', 'easting_utm'"},
      {"easting,northing,ellipsoidal height,orthometric height\n1,2,3,4\n",
       "line 1:", "z could be any of the columns 'ellipsoidal height', 'orthometric height'"},
      {"xcoord,ycoord,easting,northing\n1,2,3,4\n", "line 1:", "x could be any"},
      {"Ovest;Nord;Quota\n1;2;3\n", "line 1:", "do not name both"},
      {"# lat lat_min lon z\n1 2 3 4\n5 6 7 8\n", "line 1:", "names of columns"},
  };
  for (const Refused& c : cases) {
    expect_refused(error(c.content), c);
  }
  // The names that the documentation promises win.
  EXPECT_EQ(numbers_of(read("z,height,y,x,easting,northing\n1,2,3,4,5,6\n").columns), "4 3 1");
  EXPECT_EQ(numbers_of(read("lon,lat,x,y,z\n0,0,1,2,3\n").columns), "3 4 5");
  EXPECT_EQ(numbers_of(read("x,y,tree height\n1,2,3\n").columns), "1 2");
  EXPECT_EQ(numbers_of(read("x,y,depth\n1,2,3\n").columns), "1 2");
}

TEST_F(PointDialects, points_numbers_are_not_taken_for_x) {
  const Refused cases[] = {
      {"1,5000,5000,100,GND\n2,5010,5000,101,GND\n", "line 1:", "'GND' in column 5 is no number"},
      {"A1 5000 5000 100\nA2 5010 5000 101\n", "line 1:", "'A1' in column 1 is no number"},
      {"1,5000.5,5000,100\n2,5010,5000,101\n3,5020,5000,101\n", "points.csv:", "counts the rows"},
      {"1 5000 5000 100 7\n2 5010 5000 101 7\n3 5020 5000 101 7\n", "points.csv:", "counts"},
      {"17 5000.5 5000 100 3\n23 5010 5000 101 3\n17 5 5 5 3\n", "points.csv:", "numbers of the"},
      {"17 5000 5000 100 3\n23 5010 5000 101 3\n", "points.csv:", "could be the numbers"},
      {"1 2 3 4 5\n6 7 8 9 GND\n", "line 2:", "'GND' in column 5"},
      {"a,b,c\n1,5,5\n2,6,5\n3,7,7\n", "points.csv:", "counts the rows"},
      {"pravac,stojka,vis\n0,0,5\n0,1,5\n1,0,6\n",
       "line 1:", "do not say which columns are x and y"},
      {"first,second\n0,0\n0,1\n1,0\n", "line 1:", "do not say which columns are x and y"},
  };
  for (const Refused& c : cases) {
    expect_refused(error(c.content), c);
    EXPECT_NE(error(c.content).find("--columns x=2,y=3,z=4"), std::string::npos);
  }
  // A raster with more bands, and a cloud with colours.
  EXPECT_EQ(read("0 0 5 1\n0 1 5 1\n1 0 6 2\n").points.z, (std::vector<double>{5, 5, 6}));
  EXPECT_EQ(read("1.5 2 3 9 9 9\n2 3 4 9 9 9\n").points.z, (std::vector<double>{3, 4}));
}

TEST_F(PointDialects, other_formats_are_called_by_name) {
  const std::string stl = std::string(80, 'x') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  const Refused cases[] = {
      {"ply\nformat ascii 1.0\nelement vertex 1\n", "a mesh (PLY)", "hodt check"},
      {"# Blender\nmtllib a.mtl\no Plane\nv 1 2 3\nv 4 5 6\nf 1 2 1\n", "a mesh (OBJ)", "vertices"},
      {"v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1 2 3\n", "a mesh (OBJ)", ""},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a mesh (OFF)", ""},
      {"solid a\nfacet normal 0 0 1\nouter loop\n", "a mesh (STL)", ""},
      {stl, "a mesh (STL)", ""},
      {"ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5 6\n",
       "a raster (ESRI ASCII grid)", "gdal_translate"},
      {"NCOLS 3\r\nNROWS 2\r\n", "a raster (ESRI ASCII grid)", ""},
      {"DSAA\n2 2\n0 1\n0 1\n0 1\n1 2\n3 4\n", "a raster (Surfer grid)", ""},
      {"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\n", "a point cloud (PCD)", "pdal"},
      {"VERSION .7\nFIELDS x y z\n", "a point cloud (PCD)", ""},
      {"{\"type\": \"FeatureCollection\", \"features\": []}", "map features (GeoJSON)", "ogr2ogr"},
      {"[{\"x\": 1, \"y\": 2}]", "JSON", "table"},
      {std::string("II*\0\x08\0\0\0", 8), "a raster (TIFF)", "-of XYZ"},
      {std::string("\0\0\x27\x0A\0\0\0\0", 8), "map features (shapefile)", ""},
      {"PK\3\4\x14\6[Content_Types].xml", "a spreadsheet (xlsx or ods)", "CSV"},
      {"PK\3\4\x14\6points.csv", "an archive (zip)", "unpack"},
      {"CDF\1\0\0\0", "a raster (netCDF)", ""},
      {"\x89HDF\r\n\x1a\n", "a raster (HDF5 or netCDF)", ""},
      {"<!DOCTYPE html>\n<html><body>404</body></html>", "no data (HTML)", ""},
      {"<?xml version=\"1.0\"?>\n<LandXML>\n", "a mesh (LandXML)", ""},
      {"<?xml version=\"1.0\"?>\n<kml>\n", "map features (KML)", ""},
      {"  0\nSECTION\n  2\nHEADER\n", "map features (DXF)", ""},
      {"%PDF-1.4\n", "no data (PDF)", ""},
      {"BZh91AY", "an archive (bzip2)", "unpack"},
      {"SQLite format 3\0", "map features (SQLite or GeoPackage)", ""},
      {utf16(kCsv, true, false), "UTF-16 text without a byte order mark", "UTF-8"},
      {utf16(kCsv, false, false), "UTF-16 text without a byte order mark", "UTF-8"},
  };
  for (const Refused& c : cases) expect_refused(error(c.content), c);
}

TEST_F(PointDialects, columns_are_those_that_the_user_says) {
  const std::string table = "1,5000,5001,100,GND\n2,5010,5003,101,GND\n";
  PointTable read_as = read(table, "x=2,y=3,z=4");
  EXPECT_EQ(read_as.points.xy, (std::vector<Point>{{5000, 5001}, {5010, 5003}}));
  EXPECT_EQ(read_as.points.z, (std::vector<double>{100, 101}));
  EXPECT_FALSE(read(table, "x=3,y=2").points.has_heights());

  const std::string named = "id,foo,bar,Easting,Northing,height\n1,2,3,4,5,6\n";
  EXPECT_EQ(numbers_of(read(named, "x=foo,y=BAR,z=6").columns), "2 3 6");
  EXPECT_EQ(numbers_of(read(named, "z=bar").columns), "4 5 3");
  EXPECT_EQ(numbers_of(read(named, "x=foo,y=bar").columns), "2 3 6");
  EXPECT_EQ(read(named, "x=foo,y=bar").columns.x.name, "foo");
  EXPECT_EQ(numbers_of(read("a;b, c;d\n1;2;3\n", "x=b, c,y=d").columns), "2 3");
  EXPECT_EQ(numbers_of(read("# foo bar baz\n1 2 3\n", "x=bar,y=foo").columns), "2 1");
  EXPECT_EQ(numbers_of(read("1,2\n5,6\n7,8\n", "x=1,y=2").columns), "1 2");
  // A header of too few names does not matter where numbers say all.
  EXPECT_EQ(read("x,y,z\n7,1,2,3\n9,4,5,6\n", "x=2,y=3,z=4").points.z, (std::vector<double>{3, 6}));

  EXPECT_EQ(numbers_of(read("a;a;H\xF6"
                            "he 2\n1;2;3\n",
                            "x=2,y=1,z=h\xC3\xB6he 2")
                           .columns),
            "2 1 3");

  const Refused cases[] = {
      {"x=2,y=3,z=9", "there is no column '9'", "5 columns and no header"},
      {"x=0,y=1", "there is no column '0'", ""},
      {"x=east,y=north", "there is no column 'east'", "no header"},
      {"x=2,y=2", "x and y are both column 2", ""},
      {"z=4", "line 1:", "give x and y"},
      {"x=2,y=5", "line 1:", "'GND' for y is not a number"},
  };
  for (const auto& [columns, place, reason] : cases) {
    expect_refused(error(table, columns), {columns, place, reason});
  }
  EXPECT_NE(error(named, "x=quux").find("the columns are 'id', 'foo'"), std::string::npos);
  for (const char* bad : {"2,3,4", "x=", "x=1,x=2", "w=3", ",x=1", "="}) {
    EXPECT_NE(error(table, bad).find("x=2,y=3,z=height"), std::string::npos) << bad;
  }
}

TEST_F(PointDialects, warnings_say_what_looks_wrong) {
  const auto warning = [&](std::string_view content) {
    const auto warnings = read(content).warnings;
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
  };
  EXPECT_NE(warning("1,5000,5000\n2,5010,5000\n3,5,6\n").find("x counts 1, 2, 3"),
            std::string::npos);
  EXPECT_NE(warning("x,y,z\n7,5,5\n8,5,6\n9,6,6\n").find("x counts 7, 8, 9"), std::string::npos);
  EXPECT_NE(warning("V1,V2,V3\n5,6,7\n").find("only number the columns"), std::string::npos);
  EXPECT_NE(warning("x,y,Band 1\n1,2,3\n").find("--columns z=Band 1"), std::string::npos);
  EXPECT_NE(warning("0 0 5\n0 1 6\n1 0 -9999\n").find("1 of 3 heights is -9999"),
            std::string::npos);
  EXPECT_NE(warning("0 0 5\n0 1 6\n1 0 -3.4028234663852886e+38\n").find("-3.4028"),
            std::string::npos);
  EXPECT_NE(warning("0 0 5\n0 1 6\n1 0 1e20\n").find("1e+20"), std::string::npos);
  std::string many = "x,y,z\n";
  for (int i = 0; i < 100; ++i)
    many += std::to_string(i % 10) + "," + std::to_string(i / 10) + "," +
            (i < 40 ? "-32768" : std::to_string(i)) + "\n";
  EXPECT_NE(warning(many).find("40 of 100 heights are -32768"), std::string::npos);
  // A sea floor may be that deep.
  EXPECT_TRUE(read("0 0 -9990\n0 1 -9999\n1 0 -2000\n").warnings.empty());
}

TEST_F(PointDialects, a_late_row_can_refute_the_sample) {
  std::string head = "x;y;z\n";
  for (int i = 0; i < 20000; ++i) head += std::to_string(i % 7) + ";" + std::to_string(i) + ";5\n";
  EXPECT_EQ(read(head + "1;2;3,5\n").points.z.back(), 3.5);
  expect_refused(error(head + "1;2;3;4\n"), {"", "line 20002:", "4 values"});
  expect_refused(error(head + "1;2;3,5\n1;2;4.5\n"), {"", "line 20003:", "decimal point"});
  std::string counts = "5000 5001 100 7\n";
  for (int i = 0; i < 20000; ++i) counts += std::to_string(i / 2) + " 7 8 9\n";
  EXPECT_EQ(read(counts).points.size(), 20001u);
  EXPECT_NE(error(counts + "7 7.5 8 9\n").find("numbers of the points"), std::string::npos);
}

}  // namespace
}  // namespace hodt
