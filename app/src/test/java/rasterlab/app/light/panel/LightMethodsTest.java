package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightChoice;
import rasterlab.contract.Reflection;

/** Reads what the lab says about the methods that light its body. */
class LightMethodsTest {
    private static List<AboutText.Called> of(LightChoice choice, Language language) {
        return new LightMethods(Texts.of("light", language)).of(choice);
    }

    @ParameterizedTest(name = "the specular term that is chosen is not explained: {0}")
    @EnumSource
    void shadingsAndTheChosenTermAreExplained(Reflection reflection) {
        List<AboutText.Called> methods = of(LightChoice.first().with(reflection), Language.RUSSIAN);
        assertEquals(4, methods.size());
        String term = reflection.name().toLowerCase(Locale.ROOT).replace('_', '-');
        assertEquals(
                Texts.ofTopic("shade", Language.RUSSIAN).text(term + ".formula"),
                formula(methods.get(3)));
        for (AboutText.Called each : methods)
            assertTrue(each.texts().has(each.key() + ".formula"), each.key());
    }

    @Test
    void mixedNormalsAreExplainedToo() {
        LightChoice choice = LightChoice.first();
        LightChoice mixed = choice.with(choice.body().withNormals("angle"));
        assertEquals(
                Texts.ofTopic("vertex-normals", Language.ENGLISH).text("angle.formula"),
                formula(of(mixed, Language.ENGLISH).get(4)));
    }

    private static String formula(AboutText.Called method) {
        return method.texts().text(method.key() + ".formula");
    }

    @Test
    void eachIsExplainedBelowItsName() throws BadLocationException {
        var about = new AboutText("about", Language.ENGLISH);
        about.show(of(LightChoice.first(), Language.ENGLISH));
        String text = about.getDocument().getText(0, about.getDocument().getLength());
        int flat = text.indexOf("Method: flat");
        int gouraud = text.indexOf("Method: Gouraud");
        assertTrue(flat >= 0 && flat < text.indexOf("Source:"), text);
        assertTrue(gouraud > text.indexOf("Source:"), text);
    }
}
