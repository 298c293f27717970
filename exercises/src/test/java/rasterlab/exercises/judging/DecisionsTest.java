package rasterlab.exercises.judging;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** Tells by which value of its walk a right method decides on the item that differs. */
class DecisionsTest {
    private static final String LINE = "{\"from\":[0,0],\"to\":[5,2]}";
    private static final String CIRCLE = "{\"center\":[2,3],\"radius\":6}";
    private static final String ELLIPSE = "{\"center\":[0,0],\"rx\":6,\"ry\":3}";
    private static final String FILL =
            "{\"picture\":[\"..#.\",\"..#.\"],\"seed\":[0,0],\"with\":\"*\",\"connectivity\":4}";
    private static final String POLYGON =
            "{\"polygon\":[[0,0],[6,1],[3,5]],\"rule\":\"evenodd\",\"size\":[8,8]}";

    private static JsonNode json(String text) throws JsonProcessingException {
        return new JsonMapper().readTree(text);
    }

    private static String input(String topic) {
        return switch (topic) {
            case "line" -> LINE;
            case "circle" -> CIRCLE;
            case "ellipse" -> ELLIPSE;
            case "fill" -> FILL;
            default -> POLYGON;
        };
    }

    @ParameterizedTest(name = "the value that decides on pixel ({1}, {2}) of a {0} is another")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            line    | 2  | 1  | the right method stands at (1, 0) before: Bresenham's d is 2 there, not below 0, so it steps across, to (2, 1)
            line    | 3  | 0  | the right method stands at (2, 1) before: Bresenham's d is −4 there, below 0, so it goes straight on, to (3, 1)
            line    | 0  | 0  | the right method begins at the first end, (0, 0)
            line    | 6  | 2  | the right method stops at the second end, (5, 2)
            circle  | 3  | 9  | in its octant, counted from the centre, d is −5 at (0, 6), below 0, so v stays and (1, 6) is next
            circle  | -3 | 6  | in its octant, counted from the centre, d is 3 at (2, 6), not below 0, so v falls and (3, 5) is next
            circle  | 2  | 9  | its octant begins at (0, 6), counted from the centre: v is the radius there
            circle  | 7  | 8  | its octant ends at (4, 4), counted from the centre: all other pixels are mirror images
            ellipse | -3 | 3  | in its quarter, counted from the centre, (3, 3) is right in its column: F(u, v − ½) is −72 there, below 0, so the row sinks no further
            ellipse | 6  | -1 | in its quarter, counted from the centre, (6, 1) is right in its row: F(u + ½, v) is 369 there, not below 0, so the column moves on no further
            fill    | 1  | 1  | row 1 has the seed's character from column 0 to 1: the right method fills this run at once, places waiting on its stack: 1
            fill    | 2  | 1  | (2, 1) has another character than the seed, so the fill ends there
            fill    | 3  | 0  | (3, 0) has the seed's character, but no way from neighbour to neighbour leads there
            polygon-fill | 6 | 2 | edges that cross the line through the centres of row 2: 2; inside are the columns 2–5
            polygon-fill | 0 | 7 | no centre of row 7 lies inside, so nothing of it is filled
            """)
    void theValueAtAPixelIsTold(String topic, int x, int y, String told)
            throws JsonProcessingException {
        JsonNode none = json("{}");
        Message said =
                Decisions.of(topic, json(input(topic)), none, DifferingItem.at(new Pixel(x, y)));
        assertEquals(told, said.in("en"));
        assertTrue(said.in("ru").matches("(?s).*[а-я].*"), said.in("ru"));
    }

    @ParameterizedTest(name = "the value that decides on item {3} of {0} is another")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            point-in-triangle | {"triangle":[[0,0],[6,0],[3,5]],"points":[[3,1],[9,1]]} | {"inside":[true,false]} | 0 | the signs at the sides, from a–b on, are (1, 1, 1): no two are opposite, so it is inside
            point-in-triangle | {"triangle":[[0,0],[6,0],[3,5]],"points":[[3,1],[9,1]]} | {"inside":[true,false]} | 1 | the signs at the sides, from a–b on, are (1, −1): two are opposite, so it is outside
            point-in-triangle | {"triangle":[[0,0],[6,0],[3,0]],"points":[[9,0]]} | {"inside":[false]} | 0 | the signs at the sides are (0, 0, 0): the corners lie on one line, and the point lies beyond them
            point-in-polygon | {"polygon":[[0,0],[6,0],[3,5]],"points":[[3,1]]} | {"inside":[true]} | 0 | the right method counts crossed edges on one side of the point: 1, an odd number, so it is inside
            point-in-polygon | {"polygon":[[0,0],[6,0],[3,5]],"points":[[3,0]]} | {"inside":[true]} | 0 | it lies on edge 1, and the border belongs to the polygon
            visible-faces | {"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]],"eye":[5,5,5]} | {"visible":[false,false,true,false]} | 2 | 2·n·(eye − c₀) is 14, above 0, so the face is visible
            """)
    void theValuesAtAPointOrFaceAreTold(
            String topic, String input, String right, int index, String told)
            throws JsonProcessingException {
        var at = new DifferingItem(Optional.empty(), OptionalInt.of(index));
        assertEquals(told, Decisions.of(topic, json(input), json(right), at).in("en"));
    }

    @ParameterizedTest(name = "the codes that decide on {0}, {1}, are others")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            clip-segment | {"window":[0,0,8,8],"segments":[[1,1,7,2]]} | {"segments":[[1,1,7,2]]} | the ends of segment 1 have the codes 0000 and 0000 (bits: left, right, below, above), so all of it is left
            clip-segment | {"window":[0,0,8,8],"segments":[[-1,1,-7,9]]} | {"segments":[null]} | the ends of segment 1 have the codes 1000 and 1001 (bits: left, right, below, above), which share a bit, so nothing is left
            clip-segment | {"window":[0,0,8,8],"segments":[[-4,2,12,-2]]} | {"segments":[[0,1,4,0]]} | the ends of segment 1 have the codes 1000 and 0110 (bits: left, right, below, above), which share no bit; it comes in at t = 0.25 and goes out at t = 0.5
            clip-segment | {"window":[0,0,8,8],"segments":[[-4,2,4,-6]]} | {"segments":[null]} | the ends of segment 1 have the codes 1000 and 0010 (bits: left, right, below, above), which share no bit; but it comes in at t = 0.5 only, after going out at t = 0.25, so nothing is left
            clip-segment | {"window":[0,0,8,8],"segments":[[-4,2,4,-6]]} | {"segments":[[0,0,0,0]]} | ''
            clip-segment | {"window":[0,0,8,8],"segments":[[-1e308,1,1e308,1]]} | {"segments":[[0,1,8,1]]} | ''
            clip-volume  | {"zmin":0.25,"segments":[[0,0,0.5,0,0,1.5]]} | {"segments":[[0,0,0.5,0,0,1]]} | the ends of segment 1 have the codes 000000 and 000010 (bits: y > z, y < −z, x > z, x < −z, z > 1, z < zmin), which share no bit; it comes in at t = 0 and goes out at t = 0.5
            clip-volume  | {"zmin":0.25,"segments":[[1,2,0.5,0,3,0.5]]} | {"segments":[null]} | the ends of segment 1 have the codes 101000 and 100000 (bits: y > z, y < −z, x > z, x < −z, z > 1, z < zmin), which share a bit, so nothing is left
            """)
    void theCodesOfASegmentAreTold(String topic, String input, String right, String told)
            throws JsonProcessingException {
        var at = new DifferingItem(Optional.empty(), OptionalInt.of(0));
        Message said = Decisions.of(topic, json(input), json(right), at);
        assertEquals(told, said.in("en"));
        assertTrue(said.isEmpty() || said.in("ru").matches("(?s)код.*"), said.in("ru"));
    }

    @ParameterizedTest(name = "the vertices beyond the sides of the window are others for {0}")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            [[1,1],[7,1],[4,6]]       | no vertex of the polygon lies beyond a side of the window, so all of it is left
            [[9,1],[12,1],[9,6]]      | all vertices of the polygon lie beyond side 2 of the window, so nothing is left
            [[1,1],[12,-1],[4,12]]    | vertices of the polygon that lie beyond each side of the window, from side 1 on: 2; 2; 3; –
            """)
    void theVerticesBeyondTheWindowAreTold(String polygon, String told)
            throws JsonProcessingException {
        String input = "{\"window\":[[0,0],[8,0],[8,8],[0,8]],\"polygon\":" + polygon + "}";
        JsonNode none = json("{}");
        Message said = Decisions.of("clip-polygon", json(input), none, DifferingItem.WHOLE);
        assertEquals(told, said.in("en"));
        assertTrue(said.in("ru").matches("(?s).*[а-я].*"), said.in("ru"));
    }

    @Test
    @DisplayName("the inside of a window whose corners go clockwise is taken for its outside")
    void theWindowMayGoClockwise() throws JsonProcessingException {
        String input = "{\"window\":[[0,8],[8,8],[8,0],[0,0]],\"polygon\":[[1,1],[7,1],[4,6]]}";
        Message said = Decisions.of("clip-polygon", json(input), json("{}"), DifferingItem.WHOLE);
        assertTrue(said.in("en").startsWith("no vertex of the polygon lies beyond"), said.in("en"));
    }

    @ParameterizedTest(name = "the depths that decide on pixel ({0}, {1}) are others")
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            0 | 0 | at (0, 0) triangle 2 has depth 0.25 and 0.5 is stored: the difference −0.25 is below 0, so it is written
            2 | 0 | at (2, 0) triangle 1 has depth 0.5 and 1 is stored: the difference −0.5 is below 0, so it is written
            2 | 2 | the centre of (2, 2) lies in no triangle; on a right or bottom edge it lies outside
            """)
    void theDepthsAtAPixelAreTold(int x, int y, String told) throws JsonProcessingException {
        String input =
                "{\"triangles\":[[[0,0,0.5],[3,0,0.5],[0,3,0.5]],[[0,0,0.25],[2,0,0.25],[0,2,0.25]]],"
                        + "\"size\":[3,3]}";
        String right = "{\"pixels\":[[0,0,2,0.25],[1,0,2,0.25],[2,0,1,0.5]]}";
        DifferingItem at = DifferingItem.at(new Pixel(x, y));
        assertEquals(told, Decisions.of("depth-triangle", json(input), json(right), at).in("en"));
    }
}
