package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.shell.settings.LabTheme;

class LeftoversTest {
    static Stream<Arguments> leaving() {
        return Stream.of(
                argumentSet("type of another theme", LeavesType.class, "defaultFont: "),
                argumentSet("colours of another theme", LeavesColors.class, "look and feel: Flat"),
                argumentSet("a font put back where none was put", LeavesFont.class, "Label.font: "),
                argumentSet("the machine's language", LeavesLocale.class, "locale: ar"),
                argumentSet("who is told of failures", LeavesHandler.class, "handler of failures"),
                argumentSet("who has the keyboard", LeavesKeyboard.class, "keyboard: "),
                argumentSet("a window on the display", LeavesWindow.class, "open window: "));
    }

    @ParameterizedTest(name = "the next class begins with what one has left: {argumentSetName}")
    @MethodSource("leaving")
    void classThatLeavesItFailsAndItIsGivenBack(Class<?> leaving, String said) throws Exception {
        assumeFalse(
                leaving == LeavesWindow.class && GraphicsEnvironment.isHeadless(), "no display");
        Leftovers.Shared before = Leftovers.Shared.now();
        TestExecutionSummary run = run(leaving);
        assertEquals(1, run.getTestsSucceededCount());
        List<String> complaints = complaints(run);
        assertEquals(1, complaints.size(), complaints.toString());
        String message = complaints.get(0);
        assertTrue(message.contains(leaving.getSimpleName() + " leaves behind"), message);
        assertTrue(message.contains(said), message);
        assertEquals(before, Leftovers.Shared.now());
        EventQueue.invokeAndWait(() -> assertEquals(Optional.empty(), UsualLook.restore()));
    }

    @Test
    void classThatGivesBackWhatItInstalledPasses() {
        assertEquals(List.of(), complaints(run(GivesBack.class)));
    }

    @Test
    void classInPartsInstallsForAllOfThem() {
        TestExecutionSummary run = run(InParts.class);
        assertEquals(List.of(), complaints(run));
        assertEquals(1, run.getTestsSucceededCount());
    }

    private static List<String> complaints(TestExecutionSummary run) {
        return run.getFailures().stream().map(each -> each.getException().getMessage()).toList();
    }

    private static TestExecutionSummary run(Class<?> tests) {
        var listener = new SummaryGeneratingListener();
        LauncherFactory.create()
                .execute(
                        LauncherDiscoveryRequestBuilder.request()
                                .selectors(selectClass(tests))
                                .build(),
                        listener);
        return listener.getSummary();
    }

    /** A test that is run by the tests above alone. */
    abstract static class Leaving {
        @Test
        void leaves() throws Exception {
            EventQueue.invokeAndWait(this::leave);
        }

        abstract void leave();
    }

    static class LeavesType extends Leaving {
        @Override
        void leave() {
            LabTheme.LIGHT.install(200);
        }
    }

    static class LeavesColors extends Leaving {
        @Override
        void leave() {
            LabTheme.DARK.install();
        }
    }

    static class LeavesFont extends Leaving {
        @Override
        void leave() {
            UIManager.put("Label.font", UIManager.get("Label.font"));
        }
    }

    static class LeavesLocale extends Leaving {
        @Override
        void leave() {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
        }
    }

    static class LeavesHandler extends Leaving {
        @Override
        void leave() {
            Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {});
        }
    }

    static class LeavesKeyboard extends Leaving {
        @Override
        void leave() {
            KeyboardFocusManager.setCurrentKeyboardFocusManager(null);
        }
    }

    static class LeavesWindow extends Leaving {
        @Override
        void leave() {
            new JFrame().setVisible(true);
        }
    }

    static class GivesBack extends Leaving {
        @Override
        void leave() {
            LabTheme.PROJECTOR.install(200);
            UIManager.put("Label.font", UIManager.get("Label.font"));
            UsualLook.install();
        }
    }

    static class InParts {
        @BeforeAll
        static void install() throws Exception {
            EventQueue.invokeAndWait(LabTheme.PROJECTOR::install);
        }

        @AfterAll
        static void giveBack() throws Exception {
            EventQueue.invokeAndWait(UsualLook::install);
        }

        @Nested
        class Part {
            @Test
            void seesWhatTheWholeInstalled() {
                assertTrue(UIManager.getBoolean(StageColors.HIGH_CONTRAST));
            }
        }
    }
}
