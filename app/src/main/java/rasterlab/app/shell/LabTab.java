package rasterlab.app.shell;

import java.util.function.Supplier;
import rasterlab.app.canvas.LabPanel;

/** One tab of the window, whose panel is made when it is first asked for. On the event thread. */
public final class LabTab implements AutoCloseable {
    private final String name;
    private final String title;
    private final Supplier<LabPanel> made;
    private LabPanel panel;

    /**
     * @param name the same in every language, such as {@code line}; also the panel's component name
     * @param title in the window's language
     * @param made makes the lab's panel
     */
    LabTab(String name, String title, Supplier<LabPanel> made) {
        this.name = name;
        this.title = title;
        this.made = made;
    }

    public String name() {
        return name;
    }

    public String title() {
        return title;
    }

    /** The lab; the same one every time. */
    public LabPanel panel() {
        if (panel == null) panel = made.get();
        return panel;
    }

    @Override
    public void close() {
        if (panel != null) panel.close();
    }
}
