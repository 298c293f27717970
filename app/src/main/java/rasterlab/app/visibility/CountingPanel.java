package rasterlab.app.visibility;

import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;
import rasterlab.app.visibility.scene.StageView;

/** How far a chart is that is being counted, and the button that gives it up. */
final class CountingPanel extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;
    private final JLabel said = new JLabel();
    private final JProgressBar bar = new JProgressBar(0, 100);

    CountingPanel(VisibilityLabModel model, Texts texts) {
        super(new MigLayout("insets 12, wrap 1, gap 8", "[center,grow,fill]"));
        this.model = model;
        this.texts = texts;
        said.setName("counting");
        bar.setName("counting.progress");
        bar.setStringPainted(true);
        var cancel = new JButton(texts.text("counting.cancel"));
        cancel.setName("counting.cancel");
        cancel.addActionListener(e -> cancel());
        add(said);
        add(bar, "wmin 220");
        add(cancel, "growx 0");
        refresh(StageView.COLORS);
    }

    private void cancel() {
        model.charts().cancel();
        model.choose(choice -> choice.withView(StageView.COLORS));
    }

    /** Says what is being counted, where that is a chart. */
    void refresh(StageView view) {
        setVisible(view.isChart() && model.charts().chart().isEmpty());
        if (!view.isChart()) return;
        said.setText(texts.text("counting." + view.code()));
        bar.getAccessibleContext().setAccessibleName(said.getText());
        bar.setValue((int) Math.round(100 * model.charts().progress()));
    }
}
