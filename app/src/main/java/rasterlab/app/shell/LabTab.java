package rasterlab.app.shell;

import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.app.canvas.LabPanel;

/** One tab of the window, whose panel is made when it is first asked for. On the event thread. */
public final class LabTab implements AutoCloseable {
    private final String name;
    private final String title;
    private final Optional<Runnable> preparation;
    private final Supplier<LabPanel> made;
    private LabPanel panel;
    private boolean fresh;

    /**
     * @param name the same in every language, such as {@code line}; also the panel's component name
     * @param title in the window's language
     * @param preparation does before what the panel would take long for, on any thread; may be left
     *     out, or be run again
     * @param made makes the lab's panel
     */
    LabTab(String name, String title, Optional<Runnable> preparation, Supplier<LabPanel> made) {
        this.name = name;
        this.title = title;
        this.preparation = preparation;
        this.made = made;
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

    /** Makes the lab, unless it is there, which takes about as long as {@link #panel} then. */
    void make() {
        if (panel != null) return;
        panel = made.get();
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
