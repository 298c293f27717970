package rasterlab.app.shell.tab;

import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;

/** Says over a lab from which exercise the user's program there is, with the way back to it. */
public final class OwnStrip extends JPanel {
    private static final long serialVersionUID = 1L;

    /**
     * @param back shows the exercise
     * @param close takes the strip away
     */
    public OwnStrip(Exercise exercise, Texts texts, Runnable back, Runnable close) {
        super(new BorderLayout());
        setName("own");
        setBorder(BorderFactory.createEmptyBorder(4, 10, 0, 10));
        var row = new JPanel(FlowRows.inTheMiddle(8));
        var said = new JLabel(texts.text("own.from", exercise.title(texts.locale().getLanguage())));
        said.setName("own.from");
        row.add(said);
        row.add(button("own.back", texts, back));
        row.add(button("own.close", texts, close));
        FlowRows.keepWrapped(row);
        add(row);
    }

    private static JButton button(String key, Texts texts, Runnable action) {
        var button = new JButton(texts.text(key));
        button.setName(key);
        button.addActionListener(e -> action.run());
        return button;
    }
}
