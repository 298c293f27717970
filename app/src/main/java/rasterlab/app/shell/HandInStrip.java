package rasterlab.app.shell;

import java.awt.BorderLayout;
import java.util.function.BooleanSupplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.labs.HandInOffers.Offer;

/** Says over a lab for which exercise its input can be handed in, with the button that does it. */
final class HandInStrip extends JPanel {
    private static final long serialVersionUID = 1L;

    /**
     * @param offer what is said at first
     * @param handIn hands in what the lab shows; false where that is no input of the topic
     * @param back shows the exercise
     * @param close takes the strip away
     */
    HandInStrip(Offer offer, Texts texts, BooleanSupplier handIn, Runnable back, Runnable close) {
        super(new BorderLayout());
        setName("handIn.strip");
        setBorder(BorderFactory.createEmptyBorder(4, 10, 0, 10));
        var row = new JPanel(FlowRows.inTheMiddle(8));
        String title = offer.exercise().title(texts.locale().getLanguage());
        var said = new JLabel(words(texts, offer.refused(), title));
        said.setName("handIn.for");
        row.add(said);
        row.add(
                button(
                        "handIn",
                        texts,
                        () -> said.setText(words(texts, !handIn.getAsBoolean(), title))));
        row.add(button("own.back", texts, back));
        row.add(button("own.close", texts, close));
        FlowRows.keepWrapped(row);
        add(row);
    }

    private static String words(Texts texts, boolean refused, String title) {
        return texts.text(refused ? "handIn.nothing" : "handIn.for", title);
    }

    private static JButton button(String key, Texts texts, Runnable action) {
        var button = new JButton(texts.text(key));
        button.setName(key);
        button.addActionListener(e -> action.run());
        return button;
    }
}
