package rasterlab.app.canvas.lab;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * The rows above the stage in each mode of a lab, such as its hazards; a row is made when first
 * seen.
 *
 * @param <M> the modes
 */
public final class ModeRows<M> extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Function<M, JComponent> made;
    private final transient Map<M, JComponent> rows = new HashMap<>();

    public ModeRows(Function<M, JComponent> made) {
        super(new MigLayout("insets 0, gap 0, hidemode 3, fillx", "[grow,fill]"));
        this.made = made;
        setOpaque(false);
    }

    /** Shows the row of that mode alone. */
    public void show(M mode) {
        if (!rows.containsKey(mode)) {
            rows.put(mode, made.apply(mode));
            add(rows.get(mode), "wmin 0, growx, wrap");
        }
        rows.forEach((each, row) -> row.setVisible(each == mode));
    }
}
