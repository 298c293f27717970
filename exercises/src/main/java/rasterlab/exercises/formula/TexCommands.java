package rasterlab.exercises.formula;

import java.util.Set;
import org.scilab.forge.jlatexmath.FormulaNotFoundException;
import org.scilab.forge.jlatexmath.MacroInfo;
import org.scilab.forge.jlatexmath.SymbolAtom;
import org.scilab.forge.jlatexmath.SymbolNotFoundException;
import org.scilab.forge.jlatexmath.TeXFormula;

/**
 * The commands that statements may use: every sign of the library, and those of its macros that
 * take letters and give letters. The others define commands for all later formulas, read files and
 * addresses, choose fonts of the machine, or make anything as large as they are told.
 */
final class TexCommands {
    private static final Set<String> MACROS =
            words(
                    """
                    frac dfrac tfrac cfrac sfrac binom dbinom tbinom sqrt surd substack
                    text mbox textrm textit textbf mathrm mathbf mathit mathsf mathtt mathbb
                    mathcal mathfrak mathscr boldsymbol operatorname mathop mathbin mathrel
                    hat widehat tilde widetilde bar vec dot ddot dddot breve check acute grave
                    mathring overline underline overrightarrow overleftarrow overbrace underbrace
                    overset underset stackrel xleftarrow xrightarrow boxed phantom hphantom
                    vphantom degree pmod mod cong doteq vdots ddots int iint iiint oint
                    left right middle big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr biggr Biggr
                    limits nolimits displaystyle textstyle scriptstyle
                    thinspace medspace thickspace negthinspace quad qquad hline
                    , : ; ! \\
                    """);

    private static final Set<String> ENVIRONMENTS =
            words(
                    """
                    matrix smallmatrix pmatrix bmatrix Bmatrix vmatrix Vmatrix
                    cases array aligned split gathered
                    """);

    private static final Set<String> ESCAPED = words("{ } | # $ % & _");

    static {
        // the library knows its macros only once its formulas are loaded
        new TeXFormula();
    }

    private TexCommands() {}

    private static Set<String> words(String text) {
        return Set.of(text.strip().split("\\s+"));
    }

    /**
     * @param name without its backslash
     */
    static boolean allows(String name) {
        if (name.equals(" ") || ESCAPED.contains(name)) return true;
        return MacroInfo.Commands.containsKey(name) ? MACROS.contains(name) : isSign(name);
    }

    /** How many arguments the command takes, 0 for a sign. */
    static int arguments(String name) {
        MacroInfo macro = MacroInfo.Commands.get(name);
        return macro == null ? 0 : macro.nbArgs;
    }

    static boolean takesOptions(String name) {
        MacroInfo macro = MacroInfo.Commands.get(name);
        return macro != null && macro.hasOptions;
    }

    static boolean allowsEnvironment(String name) {
        return ENVIRONMENTS.contains(name);
    }

    private static boolean isSign(String name) {
        try {
            return TeXFormula.get(name) != null;
        } catch (FormulaNotFoundException noFormula) {
            return isSymbol(name);
        }
    }

    private static boolean isSymbol(String name) {
        try {
            return SymbolAtom.get(name) != null;
        } catch (SymbolNotFoundException noSymbol) {
            return false;
        }
    }

    /** Whether the library's own fonts have that character. */
    static boolean allows(char character) {
        return character >= ' ' && character < 0x7F
                || character >= '\u0410' && character <= '\u044F'
                || character == '\u0401'
                || character == '\u0451'
                || character == '\n'
                || character == '\t'
                || TeXFormula.symbolMappings[character] != null
                || TeXFormula.symbolFormulaMappings[character] != null;
    }
}
