package rasterlab.app.shell.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.canvas.file.PictureForm;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Pipe;

class SettingsFileTest {
    private static final LabSettings FIRST = LabSettings.first(Language.ENGLISH);

    @TempDir Path folder;
    private final List<String> problems = new ArrayList<>();

    @Test
    void firstRunOpensOnLines() {
        assertEquals("line", FIRST.tab());
    }

    @Test
    void keepsEverythingBetweenRuns() {
        var settings =
                new LabSettings(
                        new LabLook(LabTheme.DARK, Language.RUSSIAN, 125),
                        "visibility",
                        Optional.of(new Rectangle(-5, 7, 1000, 700)),
                        true,
                        false,
                        new LastChosen(
                                Optional.of(folder.resolve("a: = \\b\n é ")), PictureForm.SVG));
        Path place = folder.resolve("new").resolve("window.properties");
        file(place).save(settings);
        assertEquals(settings, file(place).load(FIRST));
        assertEquals(List.of(), problems);
    }

    @Test
    void whatAnOlderVersionDidNotKeepIsAsOnTheFirstRun() throws IOException {
        Path place = folder.resolve("window.properties");
        file(place).save(FIRST.with(new LastChosen(Optional.of(folder), PictureForm.SVG)));
        List<String> older =
                Files.readAllLines(place).stream()
                        .filter(line -> !line.matches("(text|controls|folder|picture)=.*"))
                        .toList();
        Files.write(place, older);
        assertEquals(FIRST, file(place).load(FIRST));
        assertEquals(List.of(), problems);
    }

    @Test
    @DisplayName("a folder that this run cannot name takes all other settings with it")
    void folderThatCannotBeNamedIsForgottenAlone() throws IOException {
        var kept = FIRST.with(new LastChosen(Optional.of(folder), PictureForm.SVG));
        Path place = folder.resolve("window.properties");
        file(place).save(kept);
        String text = Files.readString(place);
        Files.writeString(place, text.replaceFirst("folder=.*", "folder=\\\\u0000"));
        var forgotten = new LastChosen(Optional.empty(), PictureForm.SVG);
        assertEquals(FIRST.with(forgotten), file(place).load(FIRST));
        assertEquals(List.of(), problems);
    }

    @Test
    void firstRunHasNothingToComplainAbout() {
        assertEquals(FIRST, file(folder.resolve("none")).load(FIRST));
        assertEquals(List.of(), problems);
    }

    @Test
    void pipeStopsNoWindow() throws Exception {
        Path pipe = Pipe.at(folder.resolve("window.properties"));
        assertEquals(FIRST, file(pipe).load(FIRST));
        assertEquals(1, problems.size(), problems.toString());
        assertTrue(problems.get(0).contains("is a device, pipe or socket"), problems.get(0));
    }

    @ParameterizedTest(name = "broken file stops the window: {0}")
    @ValueSource(
            strings = {
                "",
                "theme=PINK\nlanguage=ENGLISH\ntab=\nbounds=\n",
                "theme=DARK\nlanguage=ENGLISH\ntab=line\nbounds=1 2 3\n",
                "theme=DARK\nlanguage=ENGLISH\ntab=line\nbounds=1 2 0 4\n",
                "theme=DARK\nlanguage=ENGLISH\ntab=line\nbounds=a b c d\n",
                "theme=\\u00zz\n",
            })
    void brokenFileIsToldOnceAndDoesNoHarm(String text) throws IOException {
        Path place = Files.writeString(folder.resolve("window.properties"), text);
        SettingsFile file = file(place);
        assertEquals(FIRST, file.load(FIRST));
        assertEquals(FIRST, file.load(FIRST));
        assertEquals(1, problems.size(), problems.toString());
        assertTrue(problems.get(0).contains(place.toString()), problems.get(0));
        file.save(FIRST);
        Path aside = folder.resolve("window.properties.broken");
        assertEquals(text, Files.readString(aside));
        assertTrue(problems.get(0).contains(aside.toString()), problems.get(0));
    }

    @ParameterizedTest(name = "message hides the place, the value or what is allowed: {0}={1}")
    @CsvSource(
            delimiter = ';',
            value = {
                "theme; PINK; LIGHT, DARK, PROJECTOR",
                "language; GREEK; ENGLISH, RUSSIAN",
                "text; 7; 75, 90, 100, 110, 125, 150, 175, 200",
                "maximised; maybe; true, false",
                "controls; 1; true, false",
                "picture; GIF; PNG, SVG",
                "bounds; 1 2 0 4; both sizes at least 1",
                "bounds; 1 2 3; x y width height",
                "bounds; 1 2 9999999999 4; whole numbers",
            })
    void saysThePlaceTheValueAndWhatIsAllowed(String key, String value, String allowed)
            throws IOException {
        Path place = folder.resolve("window.properties");
        file(place).save(FIRST);
        Files.writeString(place, Files.readString(place) + key + "=" + value + "\n");
        assertEquals(FIRST, file(place).load(FIRST));
        for (String part : List.of(place.toString(), "“" + key + "”", "“" + value + "”", allowed))
            assertTrue(problems.get(0).contains(part), problems.get(0) + " lacks " + part);
    }

    @Test
    void speaksRussianWithoutWordsOfTheProgram() throws IOException {
        Path place = Files.writeString(folder.resolve("window.properties"), "theme=FOO\n");
        var found = new ArrayList<Problem>();
        new SettingsFile(place, found::add).load(FIRST);
        String said = found.get(0).in(Language.RUSSIAN);
        assertTrue(said.contains("«theme» может быть одним из LIGHT, DARK, PROJECTOR"), said);
        assertFalse(said.contains("enum"), said);
    }

    @Test
    void fileInTheWayIsNamedWithoutTheClassOfTheFailure() throws IOException {
        Path blocked = Files.writeString(folder.resolve("file"), "not a folder");
        file(blocked.resolve("window.properties")).save(FIRST);
        assertTrue(problems.get(0).contains(blocked.toString()), problems.get(0));
        assertFalse(problems.get(0).contains("Exception"), problems.get(0));
    }

    @Test
    void unreadableBytesAreToldToo() throws IOException {
        Path place = folder.resolve("window.properties");
        Files.write(place, new byte[] {(byte) 0xC3, (byte) 0x28, 0, 1});
        assertEquals(FIRST, file(place).load(FIRST));
        assertEquals(1, problems.size());
    }

    @Test
    void placeThatCannotBeWrittenIsToldOnce() throws IOException {
        Path blocked = Files.writeString(folder.resolve("file"), "not a folder");
        SettingsFile file = file(blocked.resolve("window.properties"));
        file.save(FIRST);
        file.save(FIRST);
        assertEquals(1, problems.size(), problems.toString());
    }

    @Test
    void usualPlaceFollowsTheSystem() {
        var linux = properties("os.name", "Linux", "user.home", "/home/ann");
        assertEquals(
                Path.of("/home/ann/.config/rasterlab/window.properties"),
                SettingsFile.usual(Map.of(), linux));
        assertEquals(
                Path.of("/cfg/rasterlab/window.properties"),
                SettingsFile.usual(Map.of("XDG_CONFIG_HOME", "/cfg"), linux));
        linux.setProperty("rasterlab.settings", "/elsewhere/w");
        assertEquals(Path.of("/elsewhere/w"), SettingsFile.usual(Map.of(), linux));
    }

    private static Properties properties(String... pairs) {
        var properties = new Properties();
        for (int i = 0; i < pairs.length; i += 2) properties.setProperty(pairs[i], pairs[i + 1]);
        return properties;
    }

    private SettingsFile file(Path place) {
        return new SettingsFile(place, problem -> problems.add(problem.toString()));
    }
}
