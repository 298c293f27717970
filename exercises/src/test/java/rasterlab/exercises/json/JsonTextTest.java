package rasterlab.exercises.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JsonTextTest {
    /** The refusal is the same in whichever way a tree is made. */
    @ParameterizedTest(name = "{0} is taken")
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"a\": 1, \"a\": 2} | line 1, column 13: Duplicate field 'a'",
                "{} 7 | line 1, column 4: the value ends here, but something follows it",
                "[1 | line 1, column 3: the text ends here, but something in it is not closed",
                "[1; 2] | line 1, column 3: expected a comma or ], got ';'"
            })
    void whatIsNoJsonIsToldByPlaceAndWhatIsExpected(String text, String said) {
        assertRefused(said, () -> JsonText.tree(text));
        assertRefused(said, () -> JsonText.treeWithAllDigits(text));
        assertRefused(said, () -> JsonText.treeWithEndlessNumbers(text));
    }

    @Test
    @DisplayName("a draft's number is written in other digits than it was read")
    void allDigitsOfANumberAreKept() throws NotJson {
        String text = "[0.1,1.00000000000000000001]";
        assertEquals(text, JsonText.treeWithAllDigits(text).toString());
    }

    @Test
    void noNumberIsReadOnlyToBeRefusedWithItsPlace() throws NotJson {
        assertTrue(Double.isNaN(JsonText.treeWithEndlessNumbers("NaN").doubleValue()));
        assertThrows(NotJson.class, () -> JsonText.tree("NaN"));
        assertThrows(NotJson.class, () -> JsonText.treeWithAllDigits("NaN"));
    }

    private static void assertRefused(String said, Reading reading) {
        NotJson refused = assertThrows(NotJson.class, reading::read);
        assertEquals(said, refused.phrase().in("en"));
        assertEquals(said, refused.getMessage());
    }

    /** Makes a tree. */
    private interface Reading {
        void read() throws NotJson;
    }
}
