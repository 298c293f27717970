package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.Parts;
import rasterlab.app.found.FoundHazards;
import rasterlab.app.language.Language;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.scene.MethodCase;

/** A find of a search that the user keeps is a hazard of its topic's lab. */
class FoundChipTest {
    private static final String INPUT = "{\"from\":[2,5],\"to\":[9,7]}";

    @TempDir private Path settings;
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    private Path keep(String topic, String method, String input) {
        return FoundHazards.in(settings)
                .keep(
                        new MethodCase(
                                topic,
                                Optional.of(method),
                                input,
                                Optional.empty(),
                                Optional.of(new MethodCase.SearchFinding("wrong", 5))));
    }

    private interface Use {
        void of(LabTabs tabs);
    }

    private void inTabs(Use use) throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    try (var models = LabModels.first(failures::add)) {
                        models.keepSourcesIn(settings);
                        try (var tabs = LabTabs.create(models, Language.ENGLISH, failures::add)) {
                            use.of(tabs);
                        }
                    }
                });
        assertEquals(List.of(), failures);
    }

    private static Optional<JButton> chip(LabTabs tabs, String tab, String name) {
        return Parts.of(tabs.named(tab).panel())
                .filter(each -> ("chip." + name).equals(each.getName()))
                .map(JButton.class::cast)
                .findFirst();
    }

    @Test
    void clickBringsTheInputAndSaysWhatFailsThere() throws InterruptedException {
        keep("line", "naive-textbook", INPUT);
        inTabs(
                tabs -> {
                    chip(tabs, "line", "line.naive-textbook.1").orElseThrow().doClick();
                    String shown = tabs.opening().written("line").orElseThrow();
                    assertTrue(shown.replace(" ", "").contains(INPUT.replace("}", "")), shown);
                    String said =
                            Parts.of(tabs.named("line").panel())
                                    .filter(each -> "hazard.special".equals(each.getName()))
                                    .map(each -> each.getAccessibleContext().getAccessibleName())
                                    .findFirst()
                                    .orElseThrow();
                    assertTrue(said.contains("where naive-textbook is wrong"), said);
                });
    }

    @Test
    void findOfAMutantIsShownByTheMethodThatIsChosen() throws InterruptedException {
        keep("visible-faces", "turned-away", "{\"eye\":[0,0,9],\"faces\":[]}");
        keep("line", "some-mutant", INPUT);
        inTabs(
                tabs -> {
                    chip(tabs, "line", "line.some-mutant.1").orElseThrow().doClick();
                    String shown = tabs.opening().written("line").orElseThrow();
                    assertTrue(shown.replace(" ", "").contains(INPUT.replace("}", "")), shown);
                });
    }

    @Test
    void removedFindIsGoneFromTheLabAndTheDisk() throws InterruptedException {
        Path file = keep("line", "naive-textbook", INPUT);
        inTabs(
                tabs -> {
                    JButton chip = chip(tabs, "line", "line.naive-textbook.1").orElseThrow();
                    ((JMenuItem) chip.getComponentPopupMenu().getComponent(0)).doClick();
                    assertFalse(Files.exists(file));
                    assertEquals(Optional.empty(), chip(tabs, "line", "line.naive-textbook.1"));
                    assertTrue(chip(tabs, "line", "far-away").isPresent(), "others stay");
                });
    }

    /** The other modes of a tab are made when they are first shown. */
    @Test
    void labThatIsMadeLaterHasItsFindsToo() throws InterruptedException {
        keep("circle", "bresenham-textbook", "{\"centre\":[0,0],\"radius\":9}");
        inTabs(
                tabs -> {
                    assertEquals(
                            Optional.empty(), chip(tabs, "line", "circle.bresenham-textbook.1"));
                    tabs.opening().showHazard("circle", "radius-1", "bresenham");
                    assertTrue(chip(tabs, "line", "circle.bresenham-textbook.1").isPresent());
                });
    }
}
