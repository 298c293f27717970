package rasterlab.app.shell;

import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.app.canvas.LabPanel;

/** One tab of the window, whose panel is made when it is first asked for. On the event thread. */
public final class LabTab implements AutoCloseable {
    private final String name;
    private final String title;
    private final Optional<Runnable> preparation;
    private final Supplier<Supplier<LabPanel>> begun;
    private Optional<Supplier<LabPanel>> rest = Optional.empty();
    private LabPanel panel;
    private boolean fresh;

    /**
     * @param name the same in every language, such as {@code line}; also the panel's component name
     * @param title in the window's language
     * @param preparation does before what the panel would take long for, on any thread; may be left
     *     out, or be run again
     * @param begun makes a part of the lab's panel and says how the rest is made, so that none of
     *     the two takes long
     */
    LabTab(
            String name,
            String title,
            Optional<Runnable> preparation,
            Supplier<Supplier<LabPanel>> begun) {
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

    /** What shortens the first call of {@link #panel}, for another thread. */
    Optional<Runnable> preparation() {
        return preparation;
    }

    /** The first part of making the lab, unless it is there. */
    void begin() {
        if (panel == null && rest.isEmpty()) rest = Optional.of(begun.get());
    }

    /** Makes the lab, unless it is there, but for what it shows. */
    void make() {
        begin();
        if (panel != null) return;
        panel = rest.orElseThrow().get();
        rest = Optional.empty();
        fresh = true;
    }

    /** The lab; the same one every time. */
    public LabPanel panel() {
        make();
        if (fresh) panel.refresh();
        fresh = false;
        return panel;
    }

    @Override
    public void close() {
        if (panel != null) panel.close();
    }
}
