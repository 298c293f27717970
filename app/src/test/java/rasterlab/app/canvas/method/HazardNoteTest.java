package rasterlab.app.canvas.method;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Verdict;

class HazardNoteTest {
    @ParameterizedTest(name = "it is told in English: {0}")
    @ValueSource(
            strings = {"pixel (1, 2) is missing", "window must be convex, but goes round 2 times"})
    void detailIsSaidInTheWindowsLanguage(String detail) {
        var verdict = new Verdict(Verdict.Kind.WRONG, Deviation.NONE, detail);
        String note = new HazardNote("steep", "naive", verdict, List.of()).in(Language.RUSSIAN);
        assertTrue(note.contains("("), note);
        assertFalse(note.contains(" is ") || note.contains("must"), note);
    }
}
