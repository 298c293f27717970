package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;

class TourTest {
    @TempDir Path folder;

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
                        new HazardSection());
        assertFalse(tour.make(parts), "the server cannot be found");
        String html = Files.readString(tour.index());
        assertTrue(html.contains("<p class=\"failure\">"), html);
        assertTrue(html.contains("Трудные случаи"), html);
        assertTrue(log.toString(StandardCharsets.UTF_8).contains("vase: painter"));
        assertEquals("mine", Files.readString(foreign));
        assertEveryPictureIsThere(html);
    }

    @Test
    void labIsShownInEachLanguageAndTheme() throws Exception {
        var tour = new Tour(folder, Language.ENGLISH, System.err);
        List<String> labs = List.of("depth-rows", "texture-rows", "filter-rows");
        assertTrue(tour.make(List.of(new LabPictures(labs::contains))));
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
