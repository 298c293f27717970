package rasterlab.app.exercise.sheet;

import com.formdev.flatlaf.FlatClientProperties;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Texts;

/** Leads to the lab where a sheet is answered, and unfolds the sheet's document. */
public final class SheetFold extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JButton answer;
    private final JToggleButton document;

    /**
     * @param texts of the tab of exercises
     * @param toLab answers the sheet in its lab
     * @param unfold told whether the document is to be seen
     */
    public SheetFold(Texts texts, Runnable toLab, Consumer<Boolean> unfold) {
        super(new MigLayout("insets 0, gap 0 6, wrap 1", "[grow,fill]"));
        setName("sheet");
        var words = new WrappedText("sheet.about");
        words.show(texts.text("sheet.about"));
        answer = new JButton(texts.text("sheet.answer"));
        answer.setName("sheet.answer");
        answer.addActionListener(e -> toLab.run());
        document = new JToggleButton(texts.text("sheet.document"));
        document.setName("sheet.document");
        document.setToolTipText(texts.text("sheet.document.hint"));
        document.putClientProperty(FlatClientProperties.BUTTON_TYPE, "borderless");
        document.addActionListener(e -> unfold.accept(document.isSelected()));
        var buttons = new JPanel(new FlowRows(8));
        FlowRows.keepWrapped(buttons);
        buttons.add(answer);
        buttons.add(document);
        add(words, "wmin 0");
        add(buttons, "wmin 0");
    }

    /** Shows whether the document is seen. */
    public void tell(boolean unfolded) {
        document.setSelected(unfolded);
    }

    /** Gives the keyboard to the way to the lab. */
    public void focus() {
        answer.requestFocusInWindow();
    }
}
