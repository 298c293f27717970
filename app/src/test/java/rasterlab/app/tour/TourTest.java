package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.shell.UsualLook;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.study.HazardMatrix;
import rasterlab.app.tour.LabPictures.TabLook;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

@Tag("slow")
class TourTest {
    /** The pale green behind exact results in a chart of the light theme. */
    private static final Color EXACT_BAND = new Color(223, 243, 237);

    @TempDir Path folder;

    @AfterEach
    void usualLook() throws Exception {
        EventQueue.invokeAndWait(UsualLook::install);
    }

    @Test
    void partThatCannotBeMadeIsSaidAndTheRestIsMade() throws Exception {
        Path foreign = Files.writeString(folder.resolve("notes.txt"), "mine");
        var log = new ByteArrayOutputStream();
        var tour =
                new Tour(
                        folder,
                        Language.RUSSIAN,
                        new PrintStream(log, true, StandardCharsets.UTF_8));
        List<TourPart> parts =
                List.of(
                        new GradingSection(Optional.empty()),
                        new ScenePictures(),
                        new HazardSection(TourTest::recorded));
        assertFalse(tour.make(parts), "the server cannot be found");
        String html = Files.readString(tour.index());
        assertTrue(html.contains("<p class=\"failure\">"), html);
        assertTrue(html.contains("Трудные случаи"), html);
        assertTrue(log.toString(StandardCharsets.UTF_8).contains("vase: painter"));
        assertEquals("mine", Files.readString(foreign));
        assertEveryPictureIsThere(html);
        assertCellsAreRussian(html);
        assertTrue(html.contains("Тема «отрезок» (line)"), html);
        assertFalse(html.contains(">steep-upward<"), "a hazard has no words");
    }

    /** Takes the recorded verdicts, since judging takes long; RussianVerdictsTest does that. */
    private static HazardMatrix recorded(Topic<?, ?, ?> topic) {
        List<String> methods = topic.methods().stream().map(Method::name).toList();
        List<String> hazards = topic.hazards().stream().map(Hazard::name).toList();
        List<VerdictCell> cells =
                topic.hazards().stream()
                        .flatMap(hazard -> methods.stream().map(method -> recorded(hazard, method)))
                        .toList();
        return new HazardMatrix(topic.name(), methods, hazards, cells);
    }

    private static VerdictCell recorded(Hazard<?> hazard, String method) {
        Verdict.Kind kind = hazard.recorded().get(method);
        return new VerdictCell(hazard.name(), method, new Verdict(kind, Deviation.NONE, ""), kind);
    }

    @Test
    @DisplayName("why a part could not be made is told in English on a Russian page")
    void whyAPartCouldNotBeMadeIsInThePagesLanguage() throws Exception {
        var tour = new Tour(folder, Language.RUSSIAN, System.err);
        assertFalse(tour.make(List.of(new Late())));
        String html = Files.readString(tour.index());
        assertTrue(html.contains("результата нет за 5\u00a0с"), html);
    }

    private static final class Late implements TourPart {
        @Override
        public String key() {
            return "grading";
        }

        @Override
        public void make(TourPage page) throws IOException {
            throw new IOException("no result within 5 s");
        }
    }

    private static void assertCellsAreRussian(String html) {
        Matcher cell = Pattern.compile("<td[^>]*>([^<]*)<").matcher(html);
        int numbers = 0;
        for (; cell.find(); numbers += cell.group(1).matches("[0-9]+,[0-9].*") ? 1 : 0) {
            String said = cell.group(1);
            assertFalse(said.matches("[0-9]+\\.[0-9].*"), "a decimal point: " + said);
            assertFalse(said.matches(".*[a-z]+ [a-z]+ [a-z]+.*"), "English: " + said);
            assertFalse(said.matches(".*[0-9]{7}.*"), "not rounded: " + said);
        }
        assertTrue(numbers >= 30, numbers + " numbers with a decimal comma");
    }

    @Test
    @DisplayName("a study or a check is shown before it has run")
    void studyAndExerciseAreShownWithWhatCameOfThem() throws Exception {
        var tour = new Tour(folder, Language.RUSSIAN, System.err);
        // Measured in a second, where lines take ten; the tour's own study is of lines.
        var studies =
                new TourStudies(
                        StudySettings.quick(),
                        Texts.of("tour", Language.RUSSIAN),
                        System.err::println);
        Supplier<Study> charted = () -> studies.of(new ShadeTopic());
        List<String> labs = List.of("chart", "checked");
        var looks = List.of(new TabLook(LabTheme.LIGHT, Language.RUSSIAN));
        assertTrue(tour.make(List.of(new LabPictures(labs::contains, charted, looks))));
        // Which methods are beaten, and so pale, is measured; the band of exact results is not.
        assertTrue(pixels("chart", EXACT_BAND) > 5000, "no chart");
        assertTrue(pixels("checked", MethodColors.VERMILLION) > 100, "no wrong pixel is marked");
    }

    /** Pixels of that colour, or nearly: a picture that is made smaller mixes neighbours. */
    private long pixels(String lab, Color color) throws Exception {
        BufferedImage image = picture(lab);
        return IntStream.range(0, image.getWidth() * image.getHeight())
                .map(i -> image.getRGB(i % image.getWidth(), i / image.getWidth()))
                .filter(rgb -> isNearly(color, new Color(rgb)))
                .count();
    }

    private static boolean isNearly(Color one, Color other) {
        return Math.abs(one.getRed() - other.getRed()) <= 8
                && Math.abs(one.getGreen() - other.getGreen()) <= 8
                && Math.abs(one.getBlue() - other.getBlue()) <= 8;
    }

    private BufferedImage picture(String name) throws Exception {
        return ImageIO.read(folder.resolve("pictures/lab-" + name + "-ru-light.png").toFile());
    }

    @Test
    void labIsShownInEachLanguageAndTheme() throws Exception {
        var tour = new Tour(folder, Language.ENGLISH, System.err);
        List<String> labs = List.of("depth-rows", "texture-rows", "filter-rows");
        Supplier<Study> charted = () -> fail("no chart is wanted");
        assertTrue(tour.make(List.of(new LabPictures(labs::contains, charted, TabLook.all()))));
        String html = Files.readString(tour.index());
        for (String lab : labs)
            for (String look : List.of("en-light", "en-dark", "ru-light", "ru-dark"))
                assertTrue(html.contains("lab-" + lab + "-" + look), lab + " in " + look);
    }

    private void assertEveryPictureIsThere(String html) {
        Matcher source = Pattern.compile("src=\"([^\"]+)\"").matcher(html);
        int pictures = 0;
        for (; source.find(); pictures++)
            assertTrue(Files.exists(folder.resolve(source.group(1))), source.group(1));
        assertTrue(pictures >= 15, pictures + " pictures");
    }

    @Test
    void fileInPlaceOfTheFolderIsRefused() throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "mine");
        var tour = new Tour(file, Language.ENGLISH, System.err);
        var complaint = assertThrows(Complaint.class, () -> tour.make(Optional.empty()));
        assertEquals(file + ": is a file, a folder is wanted", complaint.getMessage());
        assertEquals("mine", Files.readString(file));
    }

    @Test
    void textIsEscaped() {
        assertEquals("a &lt;b&gt; &amp; &quot;c&quot;", Html.escaped("a <b> & \"c\""));
    }
}
