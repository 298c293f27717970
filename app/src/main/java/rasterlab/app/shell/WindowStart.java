package rasterlab.app.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * Opens the window as it was left.
 *
 * <p>Settings and what the labs showed are read, and the labs' models made, beside the event
 * thread, which makes the look meanwhile. Then tab, frame and picture are an event each.
 */
public final class WindowStart {
    private final Problems problems = new Problems();
    private final FailureReports reports = new FailureReports(this::show);
    private final SettingsFile file;
    private final LabSettings settings;
    private LabTabs tabs;
    private LabFrame frame;
    private boolean unmade;

    private WindowStart(Path place) {
        file = new SettingsFile(place, problems);
        settings = file.load(LabSettings.first(Language.of(Locale.getDefault())));
    }

    public static void open() {
        Path place = SettingsFile.usual(System.getenv(), System.getProperties());
        new WindowStart(place).open(place);
    }

    private void open(Path place) {
        Thread.setDefaultUncaughtExceptionHandler(reports);
        EventQueue.invokeLater(
                () -> settings.look().theme().install(settings.look().textPercent()));
        var labs =
                CompletableFuture.supplyAsync(
                        () -> LabsFile.beside(place, problems),
                        work -> new Thread(work, "labs file").start());
        var kept = labs.thenApply(LabsFile::read);
        keep(settings, file, place, problems);
        var events = new HeldEvents(EventQueue::invokeLater);
        LabModels models = LabModels.first(events, reports);
        LabsFile labsFile = labs.join();
        kept.join().ifPresent(left -> labsFile.bringBack(left, models));
        inTurn(
                List.of(
                        () -> {
                            events.letGo();
                            tabs = LabTabs.create(models, settings.look().language(), reports);
                        },
                        () -> prepare(LabTab::begin),
                        () -> prepare(LabTab::make),
                        () -> prepare(LabTab::panel),
                        () -> frame = new LabFrame(models, tabs, settings, file, labsFile, reports),
                        () -> frame.setVisible(true),
                        () -> problems.showIn(frame)));
    }

    /** Does a part of what the frame would do; what fails here fails there again, and is told. */
    private void prepare(Consumer<LabTab> part) {
        if (unmade) return;
        try {
            part.accept(tabs.namedOrFirst(settings.tab()));
        } catch (RuntimeException | LinkageError | AssertionError e) {
            unmade = true;
        }
    }

    /** Each in an event of its own; one that throws ends it. */
    private static void inTurn(List<Runnable> steps) {
        if (steps.isEmpty()) return;
        EventQueue.invokeLater(
                () -> {
                    steps.get(0).run();
                    inTurn(steps.subList(1, steps.size()));
                });
    }

    /**
     * Saves the settings at once too, so that whoever cannot write them learns so now, not when the
     * window is gone; but not over what another window may have changed since they were read.
     */
    static void keep(
            LabSettings settings, SettingsFile file, Path place, Consumer<Problem> problem) {
        boolean first = true;
        try {
            first = OneWindow.hold(place, problem);
        } catch (IOException e) {
            problem.accept(Problem.of("window.unknown", String.valueOf(e.getMessage())));
        }
        if (first) file.save(settings);
    }

    private void show(Throwable failure) {
        Language language = frame == null ? Language.ENGLISH : frame.language();
        new ErrorDialog(Texts.of("shell", language)).show(frame, failure);
    }
}
