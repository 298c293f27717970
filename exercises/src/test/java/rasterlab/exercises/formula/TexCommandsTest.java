package rasterlab.exercises.formula;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TexCommandsTest {
    /** What exercises of the course are likely to need. */
    @ParameterizedTest(name = "{0} is not drawn")
    @ValueSource(
            strings = {
                "\\frac{a}{b}+\\dfrac{a}{b}+\\tfrac12+\\cfrac1x",
                "\\sqrt{x}+\\sqrt[3]{x}+\\surd+\\binom{n}{k}+\\dbinom nk+\\tbinom nk",
                "\\mathrm{dx}\\mathbf{n}\\mathit{a}\\mathsf{a}\\mathtt{a}\\mathbb{R}\\mathcal{A}",
                "\\mathfrak{a}\\mathscr{A}\\boldsymbol{a}\\text{a b}\\textrm{a}\\textbf{a}\\textit{a}",
                "\\operatorname{sgn}x\\mathop{x}\\mathbin{x}\\mathrel{x}",
                "\\hat a\\widehat{ab}\\tilde a\\widetilde{ab}\\bar a\\vec a\\dot a\\ddot a\\dddot a",
                "\\breve a\\check a\\acute a\\grave a\\mathring a\\overline{ab}\\underline{ab}",
                "\\overrightarrow{AB}\\overleftarrow{AB}\\overbrace{a}^n\\underbrace{a}_n",
                "\\overset{a}{b}\\underset{a}{b}\\stackrel{a}{b}\\xrightarrow{a}\\xleftarrow[b]{a}",
                "\\boxed{a}\\phantom{a}\\hphantom{a}\\vphantom{a}\\substack{a\\\\b}",
                "90\\degree\\pmod n\\mod n\\cong\\doteq\\vdots\\ddots\\cdots\\ldots\\dots",
                "\\int_a^b\\iint\\iiint\\oint\\sum\\limits_{i=0}^n\\prod\\nolimits_i\\lim_{x\\to0}",
                "\\left(\\frac a b\\right]\\left\\{a\\middle|b\\right\\}\\left.x\\right|_0",
                "\\left\\lfloor x\\right\\rfloor\\big(\\Big[\\bigg\\{\\Bigg|",
                "\\bigl(\\bigr)\\Bigl(\\Bigr)\\biggl(\\biggr)\\Biggl(\\Biggr)",
                "\\displaystyle a\\textstyle b\\scriptstyle c",
                "a\\,b\\:c\\;d\\!e\\ f\\quad g\\qquad h\\thinspace i",
                "\\{\\}\\|\\#\\$\\%\\&\\_",
                "\\begin{matrix}1&0\\\\0&1\\end{matrix}\\begin{smallmatrix}1\\end{smallmatrix}",
                "\\begin{pmatrix}1\\end{pmatrix}\\begin{bmatrix}1\\end{bmatrix}",
                "\\begin{Bmatrix}1\\end{Bmatrix}\\begin{vmatrix}1\\end{vmatrix}\\begin{Vmatrix}1\\end{Vmatrix}",
                "\\begin{cases}1&x\\\\2&y\\end{cases}\\begin{array}{c|rr}1&2&3\\\\\\hline1&2&3\\end{array}",
                "\\begin{aligned}a&=b\\\\c&=d\\end{aligned}\\begin{split}a&=b\\end{split}",
                "\\begin{gathered}a\\\\b\\end{gathered}",
                "\\alpha\\beta\\gamma\\delta\\varepsilon\\theta\\lambda\\mu\\pi\\rho\\sigma\\tau\\varphi\\omega",
                "\\Gamma\\Delta\\Theta\\Lambda\\Sigma\\Phi\\Omega",
                "a\\pm b\\mp c\\cdot d\\times e\\div f\\circ g\\oplus h\\otimes i\\ast j",
                "\\le\\leq\\ge\\geq\\ne\\neq\\approx\\equiv\\sim\\ll\\gg\\in\\notin\\subset\\cup\\cap",
                "\\to\\gets\\Rightarrow\\Leftrightarrow\\mapsto\\forall\\exists\\nabla\\partial\\infty",
                "\\sin\\cos\\tan\\arctan\\log\\ln\\exp\\min\\max\\det\\arg\\langle\\rangle\\lceil\\rceil\\ell",
                "\\perp\\parallel\\angle\\emptyset\\land\\lor\\neg\\prime x'"
            })
    void known(String tex) {
        assertInstanceOf(Typeset.Drawn.class, new Formulas().set(new Formula(tex, true)), tex);
    }
}
