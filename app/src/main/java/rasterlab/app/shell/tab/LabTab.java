package rasterlab.app.shell.tab;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JEditorPane;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.ShownHazard;
import rasterlab.app.canvas.player.StepPlayer;

/** One tab of the window, whose panel is made when it is first asked for. On the event thread. */
public final class LabTab implements AutoCloseable {
    private final String name;
    private final String title;
    private final Runnable preparation;
    private final Supplier<LabPanel> begun;
    private final Deque<Runnable> parts = new ArrayDeque<>();
    private Optional<LabPanel> panel = Optional.empty();
    private Optional<StepPlayer.Playing> playing = Optional.empty();
    private Optional<ShownHazard> told = Optional.empty();
    private boolean closed;

    /**
     * @param name the same in every language, such as {@code line}; also the panel's component name
     * @param title in the window's language
     * @param preparation does before what the panel would take long for, on any thread; may be left
     *     undone, or be run again
     * @param begun makes the lab's panel, but for its parts
     */
    public LabTab(String name, String title, Runnable preparation, Supplier<LabPanel> begun) {
        this.name = name;
        this.title = title;
        this.preparation = preparation;
        this.begun = begun;
    }

    public String name() {
        return name;
    }

    public String title() {
        return title;
    }

    /** A task for another thread that shortens the first call of {@link #panel}. */
    Runnable preparation() {
        return preparation;
    }

    /** Whether the lab is made, shows what its model has, and knows its size. */
    public boolean isWhole() {
        return panel.isPresent() && parts.isEmpty();
    }

    /**
     * Makes the next part of a lab that is not whole yet. One that fails takes the parts before
     * with it, so that another try begins anew.
     */
    void makePart() {
        Runnable part = panel.isEmpty() ? this::begin : parts.remove();
        boolean made = false;
        try {
            part.run();
            made = true;
        } finally {
            if (!made) forget();
        }
    }

    /**
     * Makes the rest of the lab, each part in an event of its own.
     *
     * @param then runs in the last of them; also where the lab was closed, or a part failed, which
     *     fails again, and is told, where the lab is asked for
     */
    public void makeInEvents(Runnable then) {
        EventQueue.invokeLater(
                () -> {
                    if (closed || isWhole() || !tryPart()) then.run();
                    else makeInEvents(then);
                });
    }

    private boolean tryPart() {
        try {
            makePart();
            return true;
        } catch (RuntimeException | LinkageError | AssertionError e) {
            return false;
        }
    }

    private void begin() {
        LabPanel first = begun.get();
        panel = Optional.of(first);
        parts.addAll(first.parts());
        parts.add(
                () -> {
                    first.refresh();
                    measurePages(first);
                    playing.ifPresent(before -> goOn(first, before));
                    told.ifPresent(before -> Chips.tellAgain(before, first));
                });
        // The first measuring takes long; after it the window lays the panel out quickly.
        parts.add(first::getPreferredSize);
    }

    /** Adds a part for each page of text, in which most of the measuring goes. */
    private void measurePages(Container of) {
        for (Component each : of.getComponents())
            if (each instanceof JEditorPane page) parts.addFirst(page::getPreferredSize);
            else if (each instanceof Container inner) measurePages(inner);
    }

    private void forget() {
        parts.clear();
        panel.ifPresent(LabPanel::close);
        panel = Optional.empty();
    }

    /** How the lab plays, or will once it is made; empty where nothing does. */
    public Optional<StepPlayer.Playing> playing() {
        return isWhole() ? panel.flatMap(StepPlayer::seenIn).map(StepPlayer::playing) : playing;
    }

    /** Lets the lab play, once it is made, as another in its place did, seen or not. */
    public void goOn(StepPlayer.Playing before) {
        playing = Optional.of(before);
        if (isWhole()) panel.ifPresent(lab -> goOn(lab, before));
    }

    private static void goOn(LabPanel lab, StepPlayer.Playing before) {
        StepPlayer.seenIn(lab).ifPresent(player -> player.goOn(before));
    }

    /** The hazard that is told over the lab's stage, or will once the lab is made. */
    public Optional<ShownHazard> shownHazard() {
        return isWhole() ? panel.flatMap(Chips::shownHazardIn) : told;
    }

    /** Lets the lab, once it is made, tell what another in its place told. */
    public void tellAgain(ShownHazard before) {
        told = Optional.of(before);
        if (isWhole()) panel.ifPresent(lab -> Chips.tellAgain(before, lab));
    }

    /** The lab; the same one every time. */
    public LabPanel panel() {
        while (!isWhole()) makePart();
        return panel.orElseThrow();
    }

    /** Ends {@link #makeInEvents} too. */
    @Override
    public void close() {
        closed = true;
        panel.ifPresent(LabPanel::close);
    }
}
