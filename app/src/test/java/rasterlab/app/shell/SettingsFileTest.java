package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;

class SettingsFileTest {
    private static final LabSettings FIRST = LabSettings.first(Language.ENGLISH);

    @TempDir Path folder;
    private final List<String> problems = new ArrayList<>();

    @Test
    void keepsEverythingBetweenRuns() {
        var settings =
                new LabSettings(
                        new LabLook(LabTheme.DARK, Language.RUSSIAN, 125),
                        "visibility",
                        Optional.of(new Rectangle(-5, 7, 1000, 700)),
                        true);
        Path place = folder.resolve("new").resolve("window.properties");
        file(place).save(settings);
        assertEquals(settings, file(place).load(FIRST));
        assertEquals(List.of(), problems);
    }

    @Test
    void firstRunHasNothingToComplainAbout() {
        assertEquals(FIRST, file(folder.resolve("none")).load(FIRST));
        assertEquals(List.of(), problems);
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
        return new SettingsFile(place, problems::add);
    }
}
