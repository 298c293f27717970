package rasterlab.app.exercise.statement;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.font.LineMetrics;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import javax.swing.text.JTextComponent;
import javax.swing.text.LayeredHighlighter;
import javax.swing.text.Position;
import javax.swing.text.View;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import rasterlab.exercises.formula.Typeset;

/**
 * A formula in type where the document has its source, so that what is copied, searched and read
 * aloud is the source. It takes size and colour from the text around it and stands on its line.
 */
final class TypesetView extends View {
    /** The distance in em by which a formula may leave its line without the lines moving apart. */
    private static final double LEEWAY = 0.1;

    /**
     * The smallest part to which a thing shrinks that is wider than its line; only then the line
     * gets wider.
     */
    private static final double SMALLEST = 0.4;

    private static final FontRenderContext EXACT = new FontRenderContext(null, true, true);

    private final Typeset.FormulaOutline formula;
    private Color color;
    private Font font;
    private double em;

    /**
     * The ascent, a whole number like the places that lines are given, so that no stroke is
     * blurred.
     */
    private double ascent;

    private double descent;

    TypesetView(Element element, Typeset.FormulaOutline formula) {
        super(element);
        this.formula = formula;
    }

    /** Takes over the type around it, which a view without a parent does not know. */
    @Override
    public void setParent(View parent) {
        super.setParent(parent);
        if (parent == null) return;
        var style = ((HTMLDocument) getDocument()).getStyleSheet();
        AttributeSet attributes = style.getViewAttributes(this);
        color = style.getForeground(attributes);
        Font around = style.getFont(attributes);
        if (!around.equals(font)) measure(around);
    }

    private void measure(Font around) {
        font = around;
        em = em(font);
        LineMetrics line = font.getLineMetrics("x", EXACT);
        double leeway = LEEWAY * em;
        ascent = Math.ceil(inLine(formula.height() * em, line.getAscent(), leeway));
        descent = Math.ceil(inLine(formula.depth() * em, line.getDescent(), leeway));
    }

    /** The id of what an inline element of the statement stands for, or "". */
    static String id(Element element) {
        Object span = element.getAttributes().getAttribute(HTML.Tag.SPAN);
        Object id = span instanceof AttributeSet own ? own.getAttribute(HTML.Attribute.ID) : null;
        return id == null ? "" : id.toString();
    }

    /**
     * The size of an em, midway between letters as high as the text's small ones and as high as its
     * capitals.
     */
    private static double em(Font font) {
        double small = height(font, "x") / Typeset.FormulaOutline.X_HEIGHT;
        double capital = height(font, "E") / Typeset.FormulaOutline.CAPITAL_HEIGHT;
        return (small + capital) / 2;
    }

    private static double height(Font font, String letter) {
        return -font.createGlyphVector(EXACT, letter).getVisualBounds().getMinY();
    }

    private static double inLine(double needed, double usual, double leeway) {
        return needed <= usual + leeway ? usual : needed;
    }

    @Override
    public float getPreferredSpan(int axis) {
        return (float) (axis == X_AXIS ? Math.ceil(formula.width() * em) : ascent + descent);
    }

    @Override
    public float getMinimumSpan(int axis) {
        float usual = getPreferredSpan(axis);
        return axis == X_AXIS ? (float) Math.ceil(SMALLEST * usual) : usual;
    }

    @Override
    public float getAlignment(int axis) {
        if (axis == X_AXIS) return super.getAlignment(axis);
        double high = ascent + descent;
        return high > 0 ? (float) (ascent / high) : 0;
    }

    /** A comma stays with the formula before it. */
    @Override
    public int getBreakWeight(int axis, float from, float length) {
        return axis == X_AXIS && !spaceFollows()
                ? BadBreakWeight
                : super.getBreakWeight(axis, from, length);
    }

    private boolean spaceFollows() {
        try {
            return Character.isWhitespace(getDocument().getText(getEndOffset(), 1).charAt(0));
        } catch (BadLocationException e) {
            throw new AssertionError("a document ends with a line's end", e);
        }
    }

    @Override
    public void paint(Graphics g, Shape allocation) {
        Rectangle box = allocation.getBounds();
        var own = (Graphics2D) g.create();
        own.setColor(color);
        if (getContainer() instanceof JTextComponent pane) {
            if (pane.getHighlighter() instanceof LayeredHighlighter marks)
                marks.paintLayeredHighlights(
                        g, getStartOffset(), getEndOffset(), allocation, pane, this);
            if (isSelected(pane)) own.setColor(pane.getSelectedTextColor());
        }
        own.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        own.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        own.translate(box.x, box.y + ascent);
        double fitting = Math.min(1, box.width / getPreferredSpan(X_AXIS));
        own.scale(em * fitting, em * fitting);
        own.fill(formula.outline());
        own.dispose();
    }

    private boolean isSelected(JTextComponent pane) {
        return pane.getCaret().isSelectionVisible()
                && pane.getSelectionStart() <= getStartOffset()
                && pane.getSelectionEnd() >= getEndOffset();
    }

    @Override
    public Shape modelToView(int position, Shape allocation, Position.Bias bias)
            throws BadLocationException {
        if (position < getStartOffset() || position > getEndOffset())
            throw new BadLocationException("not in this formula", position);
        Rectangle box = allocation.getBounds();
        int x = position == getEndOffset() ? box.x + box.width : box.x;
        return new Rectangle(x, box.y, 0, box.height);
    }

    @Override
    public int viewToModel(float x, float y, Shape allocation, Position.Bias[] bias) {
        Rectangle box = allocation.getBounds();
        boolean left = x < box.x + box.width / 2.0;
        bias[0] = left ? Position.Bias.Forward : Position.Bias.Backward;
        return left ? getStartOffset() : getEndOffset();
    }
}
