package rasterlab.app.cli.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;

/** Commands that speak Russian say in Russian, too, what is wrong with their arguments. */
@Tag("slow")
class RussianComplaintsTest {
    /** Two words one after the other, or one that names nothing; names and commands stand alone. */
    private static final Pattern ENGLISH =
            Pattern.compile(
                    "(?<![/.`-])\\b[a-z]{2,} [a-z]{2,}\\b|(?<= )(an?|and|got|is|of|or|the|to)(?= )");

    private static final String CALLS =
            """
            check --lang ru
            check line-bresenham --lang ru
            check line-wu A.java --lang=ru
            check line-bresenham FOLDER/none.java --lang ru
            check line-bresenham FOLDER --lang ru
            check line-bresenham EMPTY --lang ru
            check line-bresenham PICTURE --lang RU
            check line-bresenham EMPTY more --lang ru
            check line-bresenham EMPTY --lnag ru --lang ru
            check line-bresenham EMPTY --out --lang ru
            check line-bresenham EMPTY --lang ru --lang ru
            chart --lang ru
            chart perspectiv --lang ru
            chart perspective --out a.gif --lang ru
            chart perspective --out FOLDER/none/a.svg --lang ru
            chart perspective --methods dda --lang ru
            chart line-brightness --methods dad --lang ru
            chart line-brightness --methods dda, --lang ru
            study --lang ru
            submit line-bresenham --lang ru
            study lien --lang ru
            study line --out a.gif --lang ru
            study line --out FOLDER --lang ru
            tour more --lang ru
            tour --lang ru --out
            tour --out EMPTY --lang ru
            methods lien --lang ru
            --lang ru methods line more
            hazards lien --lang ru
            rneder --lang ru
            run line --lang ru
            run line bersenham --lang ru
            run fill stacks --lang ru
            run line bresenham --hazard stepp --lang ru
            run line bresenham --hazard steep --lines --lang ru
            render vase --out FOLDER/a.png --detail 3 --lang ru
            run line bresenham --lang ru
            render --lang ru
            render vaes --out FOLDER/a.png --lang ru
            render vase --outline --visibility z16 --out FOLDER/a.png --lang ru
            render vase --lang ru
            render vase --out a.gif --lang ru
            render vase --out FOLDER/a.png --size 0x4 --lang ru
            render vase --out FOLDER/a.png --size 4 --lang ru
            render vase --out FOLDER/a.png --zoom x --lang ru
            render vase --out FOLDER/a.png --zoom 1e-9 --lang ru
            render vase --out FOLDER/a.png --clip-plane 1,2 --lang ru
            render sphere --out FOLDER/a.png --detail 0 --lang ru
            render vase --out FOLDER/a.png --near 3 --far 2 --lang ru
            render sphere --out FOLDER/a.png --detail -1 --lang ru
            render quad --out FOLDER/a.png --lang ru
            render sphere --out FOLDER/a.png --shading wire --crease 200 --lang ru
            render vase --out FOLDER/a.png --stereo anaglyph --eyes 300deg --lang ru
            render vase --out FOLDER/a.png --stereo side-by-side --size 1x1 --lang ru
            render vase --out FOLDER/a.png --stereo anaglyph --projection front --lang ru
            render vase --out FOLDER/a.png --stereo x --lang ru
            render vase --out FOLDER/a.png --cull x --lang ru
            render vase --out FOLDER/a.png --camera 1,2,0 --lang ru
            render vase --diff EMPTY --lang ru
            opengl --out FOLDER/a.png --turn 400 --lang ru
            opengl --out FOLDER/a.png --set scene=quadd --lang ru
            render vase --out FOLDER/a.png --camera 1,2 --lang ru
            render vase --out FOLDER/a.png --up y --lang ru
            render vase --out FOLDER/a.png --eyes 3deg --lang ru
            opengl --lang ru
            opengl --out FOLDER/a.png --set scene --lang ru
            opengl --out FOLDER/a.png --set sence=quad --lang ru
            completion more --lang ru
            help rneder --lang ru
            grader serve --lang ru
            bench raster --lang ru
            """;

    @TempDir Path folder;

    static Stream<String> calls() {
        return CALLS.lines();
    }

    @ParameterizedTest(name = "./lab {0} is answered in English")
    @MethodSource("calls")
    void tellsInRussian(String call) throws Exception {
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
        assertRussian(ran.err().replace(folder.toString(), ""));
    }

    @Test
    @DisplayName("a refusal to mix glass is told in English")
    void glassThatIsNotMixedIsToldInRussian() {
        String out = folder.resolve("a.png").toString();
        Ran ran =
                Ran.lab(
                        "render",
                        "transparency",
                        "--visibility=pipeline",
                        "--shading=tone",
                        "--out",
                        out,
                        "--lang",
                        "ru");
        assertEquals(3, ran.exitCode(), ran.err());
        assertRussian(ran.err());
    }

    @Test
    @DisplayName("a face that is turned round is told in English")
    void aTurnedFaceIsToldInRussian() throws IOException {
        String model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
        String file = Files.writeString(folder.resolve("turned.obj"), model).toString();
        String out = folder.resolve("a.png").toString();
        Ran ran = Ran.lab("render", file, "--visibility=convex", "--out", out, "--lang", "ru");
        assertEquals(3, ran.exitCode(), ran.err());
        assertRussian(ran.err());
    }

    @ParameterizedTest(
            name = "what a refusal asks for cannot be typed: ./lab run {0}, {1} with X = {2}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "curve forward-differences | {\"kind\":\"bezier\",\"points\":[[0,0],[0,8],[8,8],[8,0]],\"at\":[0,X,0.6666666666666666,1]} | 0.3",
                "curve adaptive | {\"kind\":\"bezier\",\"points\":[[0,0],[0,1234567.1],[8,8],[8,0]],\"flatness\":X} | 1e-9",
            })
    void whatIsAskedForIsTaken(String names, String input, String wrong) {
        String[] call = ("run " + names + " --lang ru").split(" ");
        String told = Ran.labReading(input.replace("X", wrong), call).err();
        Matcher asked = Pattern.compile("должно быть (?:не меньше )?(\\S+),").matcher(told);
        assertTrue(asked.find(), told);
        Ran.labReading(input.replace("X", asked.group(1)), call).assertDone();
    }

    static List<GoldenFile.Refused> refused() {
        var all = new ArrayList<GoldenFile.Refused>();
        for (String topic : Topics.names()) GoldenFile.refused(topic).forEach(all::add);
        return all;
    }

    private static void assertRussian(String said) {
        assertTrue(Pattern.compile("[а-яё]{3}").matcher(said).find(), said);
        assertFalse(ENGLISH.matcher(said.replaceAll("`[^`]*`|\\./lab [a-z]+", "")).find(), said);
    }

    @ParameterizedTest(name = "an input is refused in English: {0}")
    @MethodSource("refused")
    void aRefusedInputIsToldInRussian(GoldenFile.Refused one) {
        Ran ran = Ran.labReading(one.input(), "run", one.topic(), one.method(), "--lang", "ru");
        assertEquals(one.code(), ran.exitCode(), ran.err());
        assertRussian(ran.err());
    }

    @ParameterizedTest(name = "what was typed is translated or renumbered: ./lab {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "check line-bresenham nothing | nothing: такого файла нет",
                "check line-bresenham 1.0 | 1.0: такого файла нет",
                "nothing | нет команды «nothing»",
                "0.5 | нет команды «0.5»",
                "help render extra | у render нет вложенных команд, получено «extra»",
                "study circle --out points | points: неизвестное расширение",
                "render vase --out a.png --zoom 1e-9 | zoom должно быть от 1e-6 до 1000000, получено 1e-9",
            })
    void whatWasTypedStays(String call, String said) {
        String told = Ran.lab((call + " --lang ru").split(" ")).err();
        assertTrue(told.contains(said), told);
    }

    @ParameterizedTest(name = "numbers are in Java's form after: ./lab {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "render vase --depth-cue 3 | получено 3",
                "render vase --depth-cue 2.5 | получено 2.5",
                "render vase --near 5000 --far 100 | --far 100, получено 5000",
                "render cyclic-overlap --visibility convex | на расстоянии 150 единиц",
            })
    void numbersAreAsOneTypesThem(String call, String end) {
        String told = Ran.lab((call + " --out a.png --lang ru").split(" ")).err().strip();
        assertTrue(told.endsWith(end), told);
    }

    @ParameterizedTest(name = "an empty name stands for the folder of the call: ./lab {0}")
    @ValueSource(
            strings = {
                "render cube --out=",
                "render cube --diff=",
                "chart perspective --out=",
                "study line --out=",
                "opengl --out=",
                "opengl --out a.png --image=",
                "run bresenham --scene=",
                "check line-bresenham a --out="
            })
    void anEmptyNameIsRefused(String call) {
        Ran ran = Ran.lab((call + " --lang ru").split(" "));
        assertEquals(2, ran.exitCode(), ran.err());
        assertTrue(ran.err().contains("имя не может быть пустым"), ran.err());
        assertRussian(ran.err());
    }

    @Test
    @DisplayName("a file in the place of a folder is called a folder that is missing")
    void aFileIsNoFolder() throws Exception {
        Path file = Files.writeString(folder.resolve("a"), "");
        Ran ran = Ran.lab("chart", "perspective", "--out", file + "/b.svg", "--lang", "ru");
        assertTrue(ran.err().contains(file + "\u00a0— это файл, а нужна папка"), ran.err());
    }

    @Test
    @DisplayName("quotes that were typed are replaced")
    void typedQuotesStay() {
        String told =
                Ran.labReading("{\"from\":\"a'b\"}", "run", "line", "dda", "--lang", "ru").err();
        assertTrue(told.contains("\"a'b\""), told);
    }

    @Test
    @DisplayName("words are taken from a file, in another language than the one asked for")
    void aFileOfWordsIsNoCommand() throws Exception {
        Path words = Files.writeString(folder.resolve("words"), "methods line");
        Ran ran = Ran.lab("@" + words, "--lang", "ru");
        assertEquals(2, ran.exitCode(), ran.out());
        assertTrue(ran.err().contains("нет команды «@"), ran.err());
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
