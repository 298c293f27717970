package rasterlab.app.shell.labs;

import java.awt.EventQueue;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import javax.swing.Timer;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.SettingsFile;

/**
 * Writes what the user changed in the window and the labs soon afterwards, so that a program that
 * is ended from outside opens as it was left and one that is killed loses seconds.
 *
 * <p>Looks on the event thread, which costs comparing records; writes on a thread of its own.
 */
public final class StateKeeper implements AutoCloseable {
    private static final int EVERY_MILLIS = 2000;

    /** The event thread may hang or be what ends the program: then the last look is kept. */
    private static final int LAST_LOOK_MILLIS = 1500;

    private static final int WRITING_SECONDS = 10;

    private final SettingsFile file;
    private final LabsFile labsFile;
    private final Supplier<LabSettings> settings;
    private final LabModels models;
    private final Timer timer = new Timer(EVERY_MILLIS, e -> look());
    private final Thread atTheEnd = new Thread(this::endOfProgram, "last settings");
    private final ExecutorService writer =
            Executors.newSingleThreadExecutor(
                    work -> {
                        var thread = new Thread(work, "settings");
                        thread.setDaemon(true);
                        return thread;
                    });
    private volatile boolean settingsKept = true;

    /** Names of the labs whose choices could not be written yet. */
    private final Set<String> unkept = ConcurrentHashMap.newKeySet();

    private LabSettings lastSettings;

    /** Choices of the labs that were made by the last look. */
    private Map<String, Object> lastChoices;

    /**
     * Begins to look. On the event thread.
     *
     * @param settings the window's present ones, on the event thread
     */
    public StateKeeper(
            SettingsFile file,
            LabsFile labsFile,
            Supplier<LabSettings> settings,
            LabModels models) {
        this.file = file;
        this.labsFile = labsFile;
        this.settings = settings;
        this.models = models;
        lastSettings = settings.get();
        lastChoices = labsFile.used(LabsFile.choices(models));
        Runtime.getRuntime().addShutdownHook(atTheEnd);
        timer.start();
    }

    /** Has what changed since the last look written. On the event thread. */
    public void look() {
        LabSettings nowSettings = settings.get();
        if (!nowSettings.equals(lastSettings))
            writer.execute(() -> settingsKept = file.save(nowSettings));
        lastSettings = nowSettings;
        Map<String, Object> nowChoices = LabsFile.choices(models);
        Map<String, Object> asMade = labsFile.used(models.asMade());
        Set<String> changed = new HashSet<>();
        nowChoices.forEach(
                (name, choice) -> {
                    Object before = lastChoices.getOrDefault(name, asMade.get(name));
                    if (!choice.equals(before)) changed.add(name);
                });
        if (!changed.isEmpty()) writer.execute(() -> keep(nowChoices, changed));
        lastChoices = nowChoices;
    }

    private void keep(Map<String, Object> choices, Set<String> changed) {
        unkept.addAll(changed);
        if (labsFile.save(choices, unkept)) unkept.clear();
    }

    /**
     * Writes what changed since the last look, and what could not be written then; looks no more.
     * On the event thread.
     */
    @Override
    public void close() {
        timer.stop();
        try {
            Runtime.getRuntime().removeShutdownHook(atTheEnd);
        } catch (IllegalStateException ending) {
            return; // The program ends: what runs then does the rest.
        }
        look();
        finishWriting();
        if (!settingsKept) file.save(lastSettings);
        if (!unkept.isEmpty()) labsFile.save(lastChoices, unkept);
    }

    private void endOfProgram() {
        timer.stop();
        var lastLook = new FutureTask<>(this::look, null);
        EventQueue.invokeLater(lastLook);
        try {
            lastLook.get(LAST_LOOK_MILLIS, TimeUnit.MILLISECONDS);
        } catch (TimeoutException | ExecutionException e) {
            System.err.println("rasterlab: the last changes are not kept: " + e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        finishWriting();
    }

    private void finishWriting() {
        writer.shutdown();
        try {
            if (!writer.awaitTermination(WRITING_SECONDS, TimeUnit.SECONDS))
                System.err.println("rasterlab: the settings are not written yet");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
