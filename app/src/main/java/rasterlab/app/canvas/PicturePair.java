package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.geom.Rectangle2D;
import javax.swing.JPanel;

/** One picture, or two of the same part of a plane. */
public final class PicturePair extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    /** View units between the two pictures. */
    private static final int GAP = 8;

    private final PlaneView chosen;
    private final PlaneView other;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);

    public PicturePair(PlaneView chosen, PlaneView other) {
        super(null);
        this.chosen = chosen;
        this.other = other;
        setOpaque(false);
        add(chosen);
        add(other);
    }

    public PlaneView chosen() {
        return chosen;
    }

    public PlaneView other() {
        return other;
    }

    /** The picture in sight, as an SVG document. */
    public SvgDrawing svg() {
        return SvgPicture.of(this, chosen, other);
    }

    /**
     * @param all what both show, in world coordinates
     * @param two whether there are two
     */
    public void arrange(Rectangle2D all, boolean two) {
        everything = all;
        if (two == other.isVisible()) return;
        other.setVisible(two);
        revalidate();
    }

    /**
     * Places the pictures beside each other or one above the other, whichever shows everything
     * larger.
     */
    @Override
    public void doLayout() {
        int width = getWidth();
        int height = getHeight();
        if (!other.isVisible()) {
            chosen.setBounds(0, 0, width, height);
            return;
        }
        double wide = everything.getWidth();
        double tall = everything.getHeight();
        int halfWidth = (width - GAP) / 2;
        int halfHeight = (height - GAP) / 2;
        if (Math.min(halfWidth / wide, height / tall)
                >= Math.min(width / wide, halfHeight / tall)) {
            chosen.setBounds(0, 0, halfWidth, height);
            other.setBounds(width - halfWidth, 0, halfWidth, height);
        } else {
            chosen.setBounds(0, 0, width, halfHeight);
            other.setBounds(0, height - halfHeight, width, halfHeight);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return chosen.getPreferredSize();
    }

    /** Ends the threads that paint. */
    @Override
    public void close() {
        chosen.close();
        other.close();
    }
}
