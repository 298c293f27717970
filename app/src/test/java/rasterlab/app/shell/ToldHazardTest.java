package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JButton;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.language.Language;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;

/** Tells what is said over and on a stage, in another language too. */
class ToldHazardTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    @Test
    @DisplayName("another language drops the sentence of the hazard that is shown")
    void hazardIsToldInTheNextLanguage() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    try (var models = LabModels.first(failures::add)) {
                        models.of(new LightRoom()).showColors(true);
                        tellAgain(models, "light", "deep-blue");
                        tellAgain(models, "line", "far-away");
                    }
                });
        assertEquals(List.of(), failures);
    }

    private void tellAgain(LabModels models, String tab, String hazard) {
        try (var english = LabTabs.create(models, Language.ENGLISH, failures::add);
                var russian = english.again(Language.RUSSIAN)) {
            Container before = english.named(tab).panel();
            ((JButton) named(before, "chip." + hazard)).doClick();
            String said = hazardText(before);
            List<String> methods = methods(before);
            assertTrue(named(before, "hazard.strip").isVisible(), hazard);
            russian.goOnAs(english.doing());
            Container after = russian.named(tab).panel();
            assertTrue(named(after, "hazard.strip").isVisible(), hazard);
            assertEquals(methods, methods(after), "what fails there");
            assertTrue(
                    hazardText(after).matches("(?s)«.*[а-яё].*"),
                    said + " is now " + hazardText(after));
            assertTrue(((JButton) named(after, "chip." + hazard)).isSelected(), hazard);
        }
    }

    private static String hazardText(Container lab) {
        return named(lab, "hazard.special").getAccessibleContext().getAccessibleName();
    }

    private static List<String> methods(Container lab) {
        return seen(lab)
                .map(Component::getName)
                .filter(name -> name != null && name.startsWith("hazard.method."))
                .toList();
    }

    private static Component named(Container lab, String name) {
        return seen(lab).filter(each -> name.equals(each.getName())).findFirst().orElseThrow();
    }

    /** The components that are in cards that are shown. */
    private static Stream<Component> seen(Container place) {
        var all = new ArrayList<Component>();
        for (Component each : place.getComponents()) {
            boolean strip = "hazard.strip".equals(each.getName());
            if (!each.isVisible() && !strip && !(each instanceof JButton)) continue;
            all.add(each);
            if (each instanceof Container inner) all.addAll(seen(inner).toList());
        }
        return all.stream();
    }

    @Test
    @DisplayName("the sentence that says what to do lies over the stage's own words")
    void sentenceLiesBesideAStageWithWordsAtItsLowerEdge() throws InterruptedException {
        var models = new AtomicReference<LabModels>();
        var tabs = new AtomicReference<LabTabs>();
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    models.set(LabModels.first(failures::add));
                    tabs.set(LabTabs.create(models.get(), Language.RUSSIAN, failures::add));
                    tabs.get().named("polygon").panel();
                });
        LabPanel lab = tabs.get().named("polygon").panel();
        OffscreenPainter.paint(lab, 1280, 700);
        Component hint = named(lab, "stage.hint");
        for (Component each : hint.getParent().getComponents())
            if (each != hint && each.isVisible())
                assertFalse(each.getBounds().intersects(hint.getBounds()), each + " and " + hint);
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.get().close();
                    models.get().close();
                });
        assertEquals(List.of(), failures);
    }
}
