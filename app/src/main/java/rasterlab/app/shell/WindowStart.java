package rasterlab.app.shell;

import java.awt.EventQueue;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.labs.FirstCase;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.OneWindow;
import rasterlab.app.shell.settings.Problem;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.shell.tab.LayoutParts;

/**
 * Opens the window as it was left.
 *
 * <p>Settings and what the labs showed are read, the first tab's model and the look made on threads
 * beside each other. Then come events: one for each part of the first tab, and some for the frame,
 * its layout and its picture. The other models are made when the window is open.
 */
public final class WindowStart {
    private final Problems problems;
    private final FailureReports reports = new FailureReports(this::show);
    private final SettingsFile file;
    private final LabSettings kept;
    private final LabSettings settings;
    private final Optional<FirstCase> first;
    private LabTabs tabs;
    private LabFrame frame;

    private WindowStart(
            Path place, Optional<Language> asked, PrintStream err, Optional<FirstCase> first) {
        this.first = first;
        Language usual = Language.of(Locale.getDefault());
        problems = new Problems(err, asked.orElse(usual));
        file = new SettingsFile(place, problems);
        kept = file.load(LabSettings.first(usual));
        settings = kept.with(kept.look().with(asked.orElse(kept.look().language())));
        problems.speak(settings.look().language());
    }

    /**
     * @param asked for this start; empty for the language that was left
     * @param err told what is wrong with the files of the user's
     */
    public static void open(Optional<Language> asked, PrintStream err) {
        open(asked, err, Optional.empty());
    }

    /**
     * Opens the same with a case, shown in the lab of its topic once all labs are there.
     *
     * @param first what the window opens with; empty for what it was left with
     */
    public static void open(Optional<Language> asked, PrintStream err, Optional<FirstCase> first) {
        Path place = SettingsFile.usual(System.getenv(), System.getProperties());
        new WindowStart(place, asked, err, first).open(place);
    }

    private void open(Path place) {
        Thread.setDefaultUncaughtExceptionHandler(reports);
        var labsFile = LabsFile.nextTo(place, problems);
        var left = CompletableFuture.supplyAsync(labsFile::read, thread("labs file"));
        LabModels models =
                LabModels.unmade(
                        EventQueue::invokeLater,
                        labs -> left.join().ifPresent(each -> labsFile.restore(each, labs)),
                        reports);
        models.keepSourcesIn(file.folder());
        CompletableFuture<Void> made =
                CompletableFuture.runAsync(() -> models.make(settings.tab()), thread("models"));
        // Before there is any component, the look can be made on any thread.
        settings.look().theme().install(settings.look().textPercent());
        keep(kept, file, place, problems);
        SwingClasses.load(settings.look().language().locale());
        // A failure here happens again, and is reported, where the panel is made.
        made.exceptionally(again -> null).join();
        inTurn(
                List.of(
                        () -> tabs = LabTabs.create(models, settings.look().language(), reports),
                        () ->
                                tabs.namedOrFirst(settings.tab())
                                        .makeInEvents(() -> openFrame(models, labsFile))));
    }

    private static Executor thread(String name) {
        return work -> new Thread(work, name).start();
    }

    private void openFrame(LabModels models, LabsFile labsFile) {
        Language next = kept.look().language();
        frame = new LabFrame(models, tabs, settings, next, file, labsFile);
        frame.addWindowListener(
                new WindowAdapter() {
                    @Override
                    public void windowOpened(WindowEvent e) {
                        new Thread(() -> makeRest(models), "models").start();
                    }
                });
        var steps = new ArrayList<Runnable>();
        steps.add(frame::addNotify);
        steps.addAll(LayoutParts.of(frame));
        steps.add(() -> frame.setVisible(true));
        inTurn(steps);
    }

    /**
     * Makes the other labs while the first tab is looked at; then all is known that could not be
     * brought back.
     */
    private void makeRest(LabModels models) {
        try {
            models.makeAll();
            EventQueue.invokeLater(() -> first.ifPresent(this::show));
        } finally {
            problems.showIn(frame);
        }
    }

    /** Runs each in an event of its own; one that throws ends it. */
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
    public static void keep(
            LabSettings settings, SettingsFile file, Path place, Consumer<Problem> problem) {
        boolean first = true;
        try {
            first = OneWindow.hold(place, problem);
        } catch (IOException e) {
            problem.accept(Problem.of("window.unknown", String.valueOf(e.getMessage())));
        }
        if (first) file.save(settings);
    }

    private void show(FirstCase one) {
        try {
            frame.show(one);
        } catch (IllegalArgumentException e) {
            reports.accept(e);
        }
    }

    private void show(Throwable failure) {
        Language language = frame == null ? settings.look().language() : frame.language();
        new ErrorDialog(Texts.of("shell", language)).show(frame, failure);
    }
}
