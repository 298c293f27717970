package rasterlab.tests.frontdoor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
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

    static List<String> pages() {
        return Readme.PAGES;
    }

    static List<String> inBothLanguages() {
        return Readme.PAGES.stream()
                .flatMap(page -> Stream.of(page, Readme.russian(page)))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("inBothLanguages")
    void everyLinkLeadsSomewhere(String name) {
        var page = Repository.root().resolve(name);
        var broken = new ArrayList<String>();
        var links = LINK.matcher(Readme.text(name));
        while (links.find()) {
            var target = links.group(1);
            var anchor = links.group(2);
            if (target.startsWith("http")) continue;
            var file = target.isEmpty() ? page : page.resolveSibling(target);
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
    @ValueSource(strings = {"README.md", "README.ru.md"})
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

    @ParameterizedTest
    @MethodSource("pages")
    void bothLanguagesHaveTheSameCommands(String page) {
        assertEquals(
                Readme.commands(Readme.text(page)),
                Readme.commands(Readme.text(Readme.russian(page))),
                Readme.russian(page)
                        + " must have the commands of the English page, in the same order");
    }

    @ParameterizedTest
    @MethodSource("pages")
    void bothLanguagesNameTheSameFieldsFilesAndOptions(String page) {
        var english = Readme.codes(Readme.text(page));
        var russian = Readme.codes(Readme.text(Readme.russian(page)));
        var missing = new TreeSet<>(english);
        missing.removeAll(russian);
        assertEquals(
                new TreeSet<>(),
                missing,
                "name these in the Russian page, or take them out of " + page);
        var extra = new TreeSet<>(russian);
        extra.removeAll(english);
        assertEquals(
                new TreeSet<>(),
                extra,
                "name these in " + page + ", or take them out of the Russian page");
    }

    @ParameterizedTest
    @MethodSource("pages")
    void bothLanguagesHaveAsManyHeadingsPicturesAndBlocks(String page) {
        for (var line : List.of("##+ .*", "!\\[.*", "```.*", "curl .*"))
            assertEquals(
                    Readme.count(Readme.text(page), line),
                    Readme.count(Readme.text(Readme.russian(page)), line),
                    page + ": lines like " + line);
    }
}
