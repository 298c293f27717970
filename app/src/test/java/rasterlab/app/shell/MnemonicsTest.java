package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.view.ViewKind;
import rasterlab.app.language.Language;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.SplineMode;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;

/** The keys pressed with Alt, in each language and theme. */
@Tag("slow")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class MnemonicsTest {
    /**
     * @param bound whether Alt and the letter that is underlined, if any, do something
     */
    private record Mnemonic(String text, int key, boolean bound) {
        static Mnemonic of(JComponent component, String text, int index, int key) {
            return new Mnemonic(text, key, index < 0 || isBound(component, text.charAt(index)));
        }

        private static boolean isBound(JComponent component, char letter) {
            int key = KeyEvent.getExtendedKeyCodeForChar(letter);
            var pressed = KeyStroke.getKeyStroke(key, InputEvent.ALT_DOWN_MASK);
            return component.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(pressed) != null;
        }
    }

    private record Look(Language language, LabTheme theme) {}

    /** The contents of each tab and state, by its name; made once for both tests. */
    private final Map<Look, Map<String, List<Mnemonic>>> seen = new HashMap<>();

    @AfterAll
    void usualLook() throws InterruptedException {
        OffscreenPainter.onEventThread(UsualLook::install);
    }

    static Stream<Arguments> looks() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(LabTheme.values())
                                        .map(theme -> Arguments.of(language, theme)));
    }

    @ParameterizedTest(name = "one key does two things: {0}, {1}")
    @MethodSource("looks")
    void eachKeyIsUsedOnceInATab(Language language, LabTheme theme) throws InterruptedException {
        seen(language, theme)
                .forEach(
                        (tab, mnemonics) -> {
                            var texts = new HashMap<Integer, String>();
                            for (Mnemonic each : mnemonics) {
                                String other = texts.put(each.key(), each.text());
                                assertEquals(null, other, tab + ": same key as " + each.text());
                            }
                            assertTrue(texts.size() >= 8, tab + ": only " + texts);
                        });
    }

    @ParameterizedTest(name = "the underlined letter does nothing: {0}, {1}")
    @MethodSource("looks")
    void keyOfTheUnderlinedLetterIsBound(Language language, LabTheme theme)
            throws InterruptedException {
        seen(language, theme)
                .forEach(
                        (tab, mnemonics) -> {
                            for (Mnemonic each : mnemonics)
                                assertTrue(each.bound(), tab + ": " + each.text());
                        });
    }

    private Map<String, List<Mnemonic>> seen(Language language, LabTheme theme)
            throws InterruptedException {
        var look = new Look(language, theme);
        if (!seen.containsKey(look)) seen.put(look, inEachTab(language, theme));
        return seen.get(look);
    }

    private static Map<String, List<Mnemonic>> inEachTab(Language language, LabTheme theme)
            throws InterruptedException {
        var seen = new TreeMap<String, List<Mnemonic>>();
        var failure = new AtomicReference<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    theme.install();
                    try (LabModels models = LabModels.first(failure::set);
                            LabTabs tabs = LabTabs.create(models, language, failure::set)) {
                        var content =
                                new LabContent(
                                        tabs,
                                        "line",
                                        LabLook.first(language).with(theme),
                                        chosen -> {},
                                        chosen -> {});
                        for (LabTab tab : tabs.all()) {
                            content.show(tab.name());
                            seen.put(tab.name(), shown(content));
                        }
                        content.show("coordinates");
                        for (CoordinatesMode mode : CoordinatesMode.values()) {
                            models.of(new CoordinatesRoom()).show(mode);
                            seen.put("coordinates, " + mode.code(), shown(content));
                        }
                        models.of(new CoordinatesRoom()).show(CoordinatesMode.TRANSFORMATIONS);
                        models.of(new CoordinatesRoom()).transformations().show("view", "pole", "");
                        seen.put("trial", shown(content));
                        models.of(new CoordinatesRoom()).views().choose(ViewKind.SPHERICAL_LEFT);
                        models.of(new CoordinatesRoom()).show(CoordinatesMode.VIEWS);
                        seen.put("spherical view", shown(content));
                        models.of(new LightRoom()).showColors(true);
                        content.show("light");
                        seen.put("colours", shown(content));
                        models.of(new LightRoom()).rows().open("texture-filter");
                        seen.put("textures", shown(content));
                        models.of(new VisibilityRoom()).rows().open("depth-buffer");
                        content.show("visibility");
                        seen.put("depths", shown(content));
                        content.show("spline");
                        models.of(new SplineRoom()).curve().chooseForm(CurveForm.PIECES);
                        seen.put("pieces", shown(content));
                        models.of(new SplineRoom()).show(SplineMode.FUNCTION);
                        seen.put("function", shown(content));
                    }
                });
        assertEquals(null, failure.get());
        return seen;
    }

    private static List<Mnemonic> shown(Container container) {
        var found = new ArrayList<Mnemonic>();
        for (Component child : container.getComponents()) {
            if (!child.isVisible()) continue;
            if (child instanceof AbstractButton button && button.getMnemonic() != 0)
                found.add(
                        Mnemonic.of(
                                button,
                                button.getText(),
                                button.getDisplayedMnemonicIndex(),
                                button.getMnemonic()));
            if (child instanceof JLabel label && label.getDisplayedMnemonic() != 0)
                found.add(
                        Mnemonic.of(
                                label,
                                label.getText(),
                                label.getDisplayedMnemonicIndex(),
                                label.getDisplayedMnemonic()));
            if (child instanceof JTabbedPane tabs) found.addAll(titles(tabs));
            if (child instanceof Container inner) found.addAll(shown(inner));
        }
        return found;
    }

    private static List<Mnemonic> titles(JTabbedPane tabs) {
        var found = new ArrayList<Mnemonic>();
        for (int i = 0; i < tabs.getTabCount(); i++)
            found.add(
                    Mnemonic.of(
                            tabs,
                            tabs.getTitleAt(i),
                            tabs.getDisplayedMnemonicIndexAt(i),
                            tabs.getMnemonicAt(i)));
        return found;
    }
}
