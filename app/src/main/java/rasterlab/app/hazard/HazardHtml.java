package rasterlab.app.hazard;

import rasterlab.app.language.Language;
import rasterlab.engine.study.Verdict;

/** How a page of hazards looks: on a screen of any width, light or dark, and on paper. */
final class HazardHtml {
    private static final String STYLE =
            """
            :root{color-scheme:light dark}
            body{font:16px/1.5 system-ui,sans-serif;max-width:1100px;margin:0 auto;padding:16px;\
            background:#fff;color:#1b1f24}
            h1{font-size:1.6em}h2{margin-top:1.6em}h3{margin:0 0 .3em;font-size:1em}
            a{color:inherit}
            pre{background:#f3f5f7;padding:6px 10px;border-radius:4px;white-space:pre-wrap;\
            overflow-wrap:anywhere;margin:.4em 0}
            .scroll{overflow-x:auto}
            table{border-collapse:collapse;font-size:14px}
            th,td{border:1px solid #9aa3ad;padding:3px 8px;text-align:left;white-space:nowrap}
            dl{display:grid;grid-template-columns:max-content 1fr;gap:4px 12px}
            dd{margin:0}
            dt,td,h3{border-left:6px solid #9aa3ad;padding-left:8px}
            .cells{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,320px),1fr));\
            gap:16px}
            section{border:1px solid #9aa3ad;border-radius:6px;padding:10px;min-width:0;\
            break-inside:avoid}
            section p{overflow-wrap:anywhere;margin:.3em 0}
            img,svg{max-width:100%;height:auto;background:#fff}
            .flat :is(img,svg){max-width:none}
            @media(max-width:500px){dl{grid-template-columns:1fr}}
            @media(prefers-color-scheme:dark){body{background:#1b1d20;color:#f0f2f4}\
            pre{background:#25282c}}
            @media print{body{max-width:none;background:#fff;color:#000}\
            pre{background:none;border:1px solid #999}table{font-size:9px}\
            .flat :is(img,svg){max-width:100%}.scroll{overflow:visible}th,td{white-space:normal;padding:2px 3px}}
            """;

    private HazardHtml() {}

    /** A whole document. */
    static String document(String title, Language language, String body) {
        return """
            <!DOCTYPE html>
            <html lang="%s"><head><meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>%s</title>
            <style>
            %s</style></head>
            <body>
            %s</body></html>
            """
                .formatted(
                        language.locale().getLanguage(),
                        escaped(title),
                        STYLE + CommandHtml.STYLE + VerdictTable.COLORS,
                        body);
    }

    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A sign that is told without its colour. */
    static String sign(Verdict.Kind kind) {
        return switch (kind) {
            case EXACT -> "✓";
            case DEGRADED -> "≈";
            case WRONG -> "✗";
            case REFUSED -> "–";
            case ENDLESS -> "∞";
            case CRASHED -> "†";
        };
    }
}
