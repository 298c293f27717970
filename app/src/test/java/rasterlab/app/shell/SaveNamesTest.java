package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** Buttons that save say what they save, in the same words in every tab. */
class SaveNamesTest {
    @ParameterizedTest(name = "a button saves who knows what: {0}")
    @EnumSource
    void buttonsSayWhatTheySave(Language language) {
        Texts canvas = Texts.of("canvas", language);
        String picture = canvas.label("action.savePicture");
        String scene = canvas.label("action.saveScene");
        String study = Texts.of("study", language).label("save");
        for (String name : List.of(scene, study))
            assertTrue(name.matches("(Save|Сохранить) \\p{L}{4,}…"), name);
        assertTrue(picture.matches("Save picture…|Сохранить PNG/SVG…"), picture);
        assertEquals(3, new HashSet<>(List.of(picture, scene, study)).size());
        assertEquals(scene, Texts.of("visibility", language).label("save"));
    }
}
