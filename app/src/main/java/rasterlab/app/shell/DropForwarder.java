package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DropTarget;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.util.List;
import javax.swing.CellRendererPane;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import javax.swing.text.JTextComponent;
import rasterlab.app.canvas.file.FileDrop;

/**
 * Lets what is dropped on a text to be read, a list or a table go to what is around it: Swing gives
 * each of them a drop target, which refuses files without a word.
 */
final class DropForwarder extends ContainerAdapter {
    private static final DropForwarder LISTENER = new DropForwarder();

    private DropForwarder() {}

    /** Works in all that the container holds, and all that is added to it later. */
    static void within(Container container) {
        if (!GraphicsEnvironment.isHeadless()) LISTENER.open(container);
    }

    @Override
    public void componentAdded(ContainerEvent e) {
        open(e.getChild());
    }

    private void open(Component part) {
        if (part instanceof JComponent shown && takesNothing(shown))
            shown.setDropTarget(new DropTarget(shown, DnDConstants.ACTION_NONE, null, false));
        // The pane that draws cells is added again for each of them.
        if (part instanceof CellRendererPane || !(part instanceof Container container)) return;
        if (!List.of(container.getContainerListeners()).contains(this))
            container.addContainerListener(this);
        for (Component each : container.getComponents()) open(each);
    }

    private static boolean takesNothing(JComponent part) {
        TransferHandler handler = part.getTransferHandler();
        boolean typed = part instanceof JTextComponent text && text.isEditable();
        return handler != null && !(handler instanceof FileDrop) && !typed;
    }
}
