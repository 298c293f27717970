package rasterlab.app.canvas.method;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LetterLegendTest {
    private static final String LETTERS =
            "along is one axis; n and b: steps; k, also K: slope; u and v: from (0; r) on; kₐ, k_d:"
                    + " shares; Δ: difference; dx and dy: sides";

    @ParameterizedTest(name = "{0}: a letter is left out, or one that is not there is explained")
    @CsvSource(
            delimiter = '|',
            value = {
                "d = 2·b − n | along is one axis; n and b: steps",
                "Y = K·X | along is one axis; k, also K: slope",
                "u² + v² | along is one axis; u and v: from (0; r) on",
                "Δᵏ ← Δᵏ | along is one axis; Δ: difference",
                "x + dx/2, cos and sin of it | along is one axis; dx and dy: sides",
                "f·kₐ | along is one axis; k, also K: slope; kₐ, k_d: shares",
                "the farthest first | along is one axis"
            })
    void onlyTheLettersOfTheFormulaAreExplained(String formula, String legend) {
        assertEquals(legend, LetterLegend.of(LETTERS, formula));
    }
}
