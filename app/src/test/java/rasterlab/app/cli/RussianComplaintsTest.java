package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Commands that speak Russian say in Russian, too, what is wrong with their arguments. */
class RussianComplaintsTest {
    /** Two words one after the other; names and commands stand alone. */
    private static final Pattern ENGLISH = Pattern.compile("(?<![/.`-])\\b[a-z]{2,} [a-z]{2,}\\b");

    @TempDir Path folder;

    @ParameterizedTest(name = "./lab {0} is answered in English")
    @ValueSource(
            strings = {
                "check --lang ru",
                "check line-bresenham --lang ru",
                "check line-wu A.java --lang=ru",
                "check line-bresenham FOLDER/none.java --lang ru",
                "check line-bresenham FOLDER --lang ru",
                "check line-bresenham EMPTY --lang ru",
                "check line-bresenham PICTURE --lang RU",
                "check line-bresenham EMPTY more --lang ru",
                "check line-bresenham EMPTY --lnag ru --lang ru",
                "check line-bresenham EMPTY --out --lang ru",
                "check line-bresenham EMPTY --lang ru --lang ru",
                "chart --lang ru",
                "chart perspectiv --lang ru",
                "chart perspective --out a.gif --lang ru",
                "chart perspective --out FOLDER/none/a.svg --lang ru",
                "chart perspective --methods dda --lang ru",
                "chart line-brightness --methods dad --lang ru",
                "chart line-brightness --methods dda, --lang ru",
                "study --lang ru",
                "study lien --lang ru",
                "study line --out a.gif --lang ru",
                "study line --out FOLDER --lang ru",
                "tour more --lang ru",
                "tour --lang ru --out",
                "tour --out EMPTY --lang ru"
            })
    void tellsInRussian(String call) throws Exception {
        assertToldInRussian(call);
    }

    @ParameterizedTest(name = "./lab {0} is answered in English")
    @ValueSource(
            strings = {
                "methods lien --lang ru",
                "--lang ru methods line more",
                "hazards lien --lang ru",
                "rneder --lang ru",
                "run line --lang ru",
                "run line bersenham --lang ru",
                "run line bresenham --lang ru",
                "render --lang ru",
                "render vaes --out a.png --lang ru",
                "render vase --lang ru",
                "render vase --out a.gif --lang ru",
                "render vase --out FOLDER/a.png --size 0x4 --lang ru",
                "render vase --out FOLDER/a.png --zoom x --lang ru",
                "render vase --out FOLDER/a.png --camera 1,2 --lang ru",
                "render vase --out FOLDER/a.png --up y --lang ru",
                "render vase --out FOLDER/a.png --eyes 3deg --lang ru",
                "opengl --lang ru",
                "opengl --out FOLDER/a.png --set scene --lang ru",
                "opengl --out FOLDER/a.png --set sence=quad --lang ru",
                "completion more --lang ru",
                "help rneder --lang ru",
                "grader serve --lang ru",
                "bench raster --lang ru"
            })
    void everyCommandTellsInRussian(String call) throws Exception {
        assertToldInRussian(call);
    }

    private void assertToldInRussian(String call) throws Exception {
        Path empty = Files.createFile(folder.resolve("a.java"));
        byte[] png = "\u0089PNG\r\n\u001a\n....".getBytes(StandardCharsets.ISO_8859_1);
        Path picture = Files.write(folder.resolve("b.java"), png);
        String[] arguments =
                call.replace("FOLDER", folder.toString())
                        .replace("EMPTY", empty.toString())
                        .replace("PICTURE", picture.toString())
                        .split(" ");
        Ran ran = Ran.lab(arguments);
        assertEquals(2, ran.exitCode(), ran.err());
        assertEquals("", ran.out());
        assertEquals(1, ran.err().lines().count(), ran.err());
        String said = ran.err().replace(folder.toString(), "");
        assertTrue(Pattern.compile("[а-яё]{3}").matcher(said).find(), said);
        assertFalse(ENGLISH.matcher(said.replaceAll("`[^`]*`|\\./lab [a-z]+", "")).find(), said);
    }

    @ParameterizedTest(name = "names are in straight quotes after: ./lab {0}")
    @ValueSource(strings = {"check --lang ru", "check line-wu --lang ru", "opengl --lang ru"})
    void namesAreInRussianQuotes(String call) {
        String said = Ran.lab(call.split(" ")).err();
        assertTrue(said.contains("«"), said);
        assertFalse(said.contains("'"), said);
    }

    @Test
    @DisplayName("an unknown language is answered in another one than English")
    void anUnknownLanguageIsToldInEnglish() {
        Ran ran = Ran.lab("chart", "perspective", "--lang", "de");
        assertTrue(ran.err().contains("expected one of en, ru, got 'de'"), ran.err());
        assertEquals(2, ran.exitCode());
    }
}
