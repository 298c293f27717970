package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;

class LineInputTest {
    @Test
    void readsEndsAndWindow() {
        var whole = new Segment(-1, 2, 7, 2147483647);
        assertEquals(whole, LineInput.read("{\"from\":[-1,2],\"to\":[7,2147483647]}"));
        assertEquals(
                whole.in(new PixelWindow(0, 0, 5, 6)),
                LineInput.read("{\"to\":[7,2147483647],\"window\":[0,0,5,6],\"from\":[-1,2]}"));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "7| input must be an object {…}, got 7",
                "{\"to\":[0,0]}| input, field 'from' is missing",
                "{\"from\":[0,0]}| input, field 'to' is missing",
                "{\"from\":[0],\"to\":[0,0]}|"
                        + " input, field 'from' must be a point [x, y], got [0]",
                "{\"from\":[0,0],\"to\":[0,0.5]}|"
                        + " input, field 'to' must be a whole number from -2147483648 to"
                        + " 2147483647, got 0.5",
                "{\"from\":[0,0],\"to\":[0,1],\"window\":[1,2,3]}|"
                        + " input, field 'window' must have 4 whole numbers, got [1,2,3]",
                "{\"from\":[0,0],\"to\":[0,1],\"window\":[5,0,1,9]}|"
                        + " xmin must be at most xmax, got 5 > 1",
                "{\"from\":[0,0],\"to\":[0,1],\"x\":1}|"
                        + " input, field 'x' is not known here; known are [from, to, window]"
            })
    void refusesInTheseWords(String json, String said) {
        var refusal =
                assertThrows(IllegalArgumentException.class, () -> LineInput.read(json.strip()));
        assertEquals(said, refusal.getMessage());
    }
}
