package rasterlab.exercises.formula;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.scilab.forge.jlatexmath.Box;
import org.scilab.forge.jlatexmath.DefaultTeXFontParser;
import org.scilab.forge.jlatexmath.NewEnvironmentMacro;
import org.scilab.forge.jlatexmath.TeXConstants;
import org.scilab.forge.jlatexmath.TeXFormula;
import rasterlab.exercises.score.Message;

/**
 * Sets formulas with JLaTeXMath. Its fonts and commands stand in static maps without locks, so one
 * formula is set at a time. The first one takes some tenths of a second, since it reads fonts.
 */
final class Typesetter {
    private static final Object LIBRARY = new Object();

    /** Outlines of letters are rounded at small sizes. */
    private static final double UNITS_PER_EM = 1000;

    /** Wider or higher formulas are mistakes, in em. */
    private static final int LARGEST = 200;

    /** Words; a sign alone in braces; a sign of a list with the space and the minus after it. */
    private static final Pattern SIGNS =
            Pattern.compile(
                    "\\\\text\\{[^{}]*\\}|\\{([-+*=<>:,;]|\\\\pm)\\}"
                            + "|(?<!\\\\)([,;])((?:\\s|\\\\ )*)(-|\\\\pm(?![a-z]))?");

    private Typesetter() {}

    static Typeset set(TexFormula formula) {
        synchronized (LIBRARY) {
            return checked(formula);
        }
    }

    private static Typeset checked(TexFormula formula) {
        try {
            Library.prepare();
            Optional<Message> mistake = TexCheck.mistake(formula.tex());
            return mistake.isPresent() ? new Typeset.Mistaken(mistake.get()) : drawn(formula);
        } catch (StackOverflowError e) {
            return new Typeset.Mistaken(Message.of("formula.nested"));
        } catch (LinkageError | InternalError e) {
            // A Java without a screen may come without the libraries that read fonts.
            return new Typeset.Mistaken(Message.of("formula.fonts", e));
        } catch (RuntimeException e) {
            // The library throws whatever its parser ran into.
            String said = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
            return new Typeset.Mistaken(Message.of("formula.other", said));
        }
    }

    /** A task that is to be done once. */
    private static final class Library {
        static {
            DefaultTeXFontParser.registerFonts(false);
            new TeXFormula();
            // It leaves out the gap before the conditions.
            NewEnvironmentMacro.addReNewEnvironment(
                    "cases", "\\left\\{\\begin{array}{l@{\\quad}l}", "\\end{array}\\right.", 0);
        }

        static void prepare() {}
    }

    private static Typeset drawn(TexFormula formula) {
        int style = formula.displayed() ? TeXConstants.STYLE_DISPLAY : TeXConstants.STYLE_TEXT;
        Box box =
                new TeXFormula(spaced(formula.tex()))
                        .createTeXIcon(style, (float) UNITS_PER_EM, true)
                        .getBox();
        float largest = Math.max(box.getWidth(), box.getHeight() + box.getDepth());
        if (!(largest <= LARGEST))
            return new Typeset.Mistaken(Message.of("formula.large", Math.round(largest), LARGEST));
        var graphics = new OutlineGraphics();
        graphics.scale(UNITS_PER_EM, UNITS_PER_EM);
        box.draw(graphics, 0, 0);
        Shape outline =
                AffineTransform.getScaleInstance(1 / UNITS_PER_EM, 1 / UNITS_PER_EM)
                        .createTransformedShape(graphics.outline());
        return new Typeset.FormulaOutline(outline, box.getWidth(), box.getHeight(), box.getDepth());
    }

    /**
     * The library gives a comma after a digit or a bracket no space, so that 0, 1 looks like 0,1,
     * and takes a minus after it for a difference. A sign alone in braces loses its spaces in all
     * formulas that follow, so none is handed on like that.
     */
    private static String spaced(String tex) {
        return SIGNS.matcher(tex).replaceAll(found -> Matcher.quoteReplacement(spaced(found)));
    }

    private static String spaced(MatchResult found) {
        String alone = found.group(1);
        String listed = found.group(2);
        if (alone != null) return "{" + ordinary(alone) + "}";
        if (listed == null) return found.group();
        String gap = found.group(3);
        String space = gap.isBlank() && !gap.isEmpty() ? "\\, " : gap;
        return ordinary(listed) + space + (found.group(4) == null ? "" : ordinary(found.group(4)));
    }

    private static String ordinary(String sign) {
        return "\\mathord{" + sign + "}";
    }
}
