package rasterlab.app.canvas.lab;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.JPanel;

/** A lab as the window shows it, in one language and theme; its model outlives it. */
public abstract class LabPanel extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    protected LabPanel() {
        super(new BorderLayout());
    }

    /**
     * The parts of the panel that are still to be made before it first shows anything: each once,
     * in this order, in an open window in an event of its own, between which the window answers.
     * Until then the panel can only be closed.
     */
    public List<Runnable> parts() {
        return List.of();
    }

    /**
     * Shows what the model has. Whoever makes the panel asks for it before the panel is seen, in an
     * event of its own where one would take long; later the panel asks itself.
     */
    public abstract void refresh();

    /** Gives the keyboard to the lab's picture, whose keys change what it shows. */
    public abstract void focusPicture();

    /** Stops what it plays, for it is not seen any more. */
    public void stop() {}

    /** Stops what the panel plays and listens to; the model lives on. On the event thread. */
    @Override
    public abstract void close();
}
