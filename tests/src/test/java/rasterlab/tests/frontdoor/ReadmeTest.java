package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneView;
import rasterlab.tests.Repository;

class ReadmeTest {
    private static final Pattern SCENE_FILE =
            Pattern.compile("(?m)^```json\\R(.*?)^```", Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]*)(#[^)]*)?\\)");

    static List<String> names() {
        return Readme.NAMES;
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyLinkLeadsSomewhere(String name) {
        var broken = new ArrayList<String>();
        var links = LINK.matcher(Readme.text(name));
        while (links.find()) {
            var target = links.group(1).isEmpty() ? name : links.group(1);
            var anchor = links.group(2);
            if (target.startsWith("http")) continue;
            var file = Repository.root().resolve(target);
            if (!Files.exists(file)) broken.add(target);
            else if (anchor != null && !anchors(Repository.text(file)).contains(anchor))
                broken.add(target + anchor);
        }
        assertEquals(List.of(), broken, name + ": no file or heading is there; mend the link");
    }

    /** The headings of a text as links name them. */
    private static List<String> anchors(String text) {
        return text.lines()
                .filter(line -> line.startsWith("#"))
                .map(line -> line.replaceFirst("#+ ", "").toLowerCase())
                .map(line -> "#" + line.replaceAll("[^\\p{L}\\d -]", "").replace(' ', '-'))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("names")
    void theSceneFileIsReadAndSaysEverything(String name) {
        var block = SCENE_FILE.matcher(Readme.text(name));
        assertTrue(block.find(), name + " shows no scene file");
        var view = (SceneView) SceneFile.read(block.group(1));
        for (var settings : List.of(SceneSetting.OF_VIEW, SceneSetting.OF_LOOK))
            for (var setting : settings)
                assertTrue(
                        view.settings().get(setting).isPresent(),
                        name + ": show " + setting + " in the scene file");
    }

    @Test
    void bothLanguagesHaveTheSameCommands() {
        assertEquals(
                Readme.commands(),
                Readme.commands(Readme.text("README.ru.md")),
                "README.ru.md must have the commands of README.md, in the same order");
    }

    @Test
    void bothLanguagesNameTheSameFieldsFilesAndOptions() {
        var english = Readme.codes(Readme.text());
        var russian = Readme.codes(Readme.text("README.ru.md"));
        var missing = new TreeSet<>(english);
        missing.removeAll(russian);
        assertEquals(
                new TreeSet<>(),
                missing,
                "name these in README.ru.md, or take them out of README.md");
        var extra = new TreeSet<>(russian);
        extra.removeAll(english);
        assertEquals(
                new TreeSet<>(),
                extra,
                "name these in README.md, or take them out of README.ru.md");
    }

    @ParameterizedTest
    @ValueSource(strings = {"## .*", "!\\[.*", "```.*", "curl .*"})
    void bothLanguagesHaveAsMany(String line) {
        var russian = Readme.count(Readme.text("README.ru.md"), line);
        assertEquals(Readme.count(Readme.text(), line), russian, "lines like " + line);
    }
}
