package rasterlab.app.visibility;

import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;

/** How far a chart is that is being counted, and the button that gives it up. */
final class CountingPanel extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient VisibilityLabModel model;
    private final JProgressBar bar = new JProgressBar(0, 100);

    CountingPanel(VisibilityLabModel model, Texts texts) {
        super(new MigLayout("insets 12, wrap 1, gap 8", "[center,grow,fill]"));
        this.model = model;
        var said = new JLabel(texts.text("counting"));
        said.setName("counting");
        bar.setName("counting.progress");
        bar.getAccessibleContext().setAccessibleName(texts.text("counting"));
        bar.setStringPainted(true);
        var cancel = new JButton(texts.text("counting.cancel"));
        cancel.setName("counting.cancel");
        cancel.addActionListener(e -> cancel());
        add(said);
        add(bar, "wmin 220");
        add(cancel, "growx 0");
        setVisible(false);
    }

    private void cancel() {
        model.charts().cancel();
        model.choose(choice -> choice.withView(StageView.COLOURS));
    }

    /**
     * @param wanted whether a chart is what the stage shows
     */
    void refresh(boolean wanted) {
        setVisible(wanted && model.charts().chart().isEmpty());
        bar.setValue((int) Math.round(100 * model.charts().progress()));
    }
}
