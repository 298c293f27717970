package rasterlab.app.canvas;

import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The topic's hazards above the stage: one click brings the input on which methods fail. */
public final class Chips extends JPanel {
    private static final long serialVersionUID = 1L;

    public Chips(String title) {
        super(new FlowRows(6));
        setOpaque(false);
        var label = new JLabel(title);
        label.setName("chips.title");
        add(label);
        addComponentListener(
                new ComponentAdapter() {
                    @Override
                    public void componentResized(ComponentEvent e) {
                        revalidate();
                    }
                });
    }

    /**
     * @param name the hazard's name as on the command line
     * @param text what the chip says
     * @param hint one sentence: what is special about the input
     */
    public void add(String name, String text, String hint, Runnable action) {
        var chip = new JButton(text);
        chip.setName("chip." + name);
        chip.setToolTipText(hint);
        chip.getAccessibleContext().setAccessibleDescription(hint);
        chip.putClientProperty("JButton.buttonType", "roundRect");
        chip.putClientProperty("FlatLaf.styleClass", "medium");
        chip.putClientProperty("FlatLaf.style", "margin: 2,4,2,4; minimumWidth: 0");
        chip.addActionListener(e -> action.run());
        add(chip);
    }

    /** The title lies in the middle of the first row of chips. */
    @Override
    public void doLayout() {
        super.doLayout();
        if (getComponentCount() > 1) {
            Component title = getComponent(0);
            title.setSize(title.getWidth(), getComponent(1).getHeight());
        }
    }
}
