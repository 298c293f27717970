package rasterlab.app.row;

import java.awt.CardLayout;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JPanel;

/** The lab of rows beside the other labs of its tab; made when it is first seen. */
public final class RowCard {
    private static final String NAME = "rows";

    private final JPanel shown;
    private final CardLayout cards;
    private final Supplier<RowPanel> make;
    private Optional<RowPanel> made = Optional.empty();

    /**
     * @param shown has the tab's labs as cards
     */
    public RowCard(JPanel shown, CardLayout cards, Supplier<RowPanel> make) {
        this.shown = shown;
        this.cards = cards;
        this.make = make;
    }

    /** Brings it before the other cards. */
    public void show() {
        if (made.isEmpty()) {
            made = Optional.of(make.get());
            made.get().refresh();
            shown.add(made.get(), NAME);
        }
        cards.show(shown, NAME);
    }

    public void focusPicture() {
        made.ifPresent(RowPanel::focusPicture);
    }

    /** Stops playing, for it is not seen any more. */
    public void stop() {
        made.ifPresent(RowPanel::stop);
    }

    /** Stops playing and listening for good. */
    public void close() {
        made.ifPresent(RowPanel::close);
    }
}
