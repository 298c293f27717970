package rasterlab.grader.institution

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.course.RosterColumn
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.OnceOnly
import java.net.URI
import java.time.InstantSource

/**
 * An account that a person may enter.
 *
 * @param course its name; empty for staff, who teach all
 */
data class Entrance(
    val who: Identity,
    val course: String,
)

/** The accounts that a person may enter, and the [page] that they wanted. */
class Entrances(
    val all: List<Entrance>,
    val page: String,
)

/** @param accounts the id of each and the name of its course */
@Serializable
private class KeptEntrances(
    val accounts: List<Pair<String, String>>,
    val page: String,
)

/** A sign-in that goes on elsewhere: at the [place], with a [key] that the browser keeps until it comes back. */
class Errand(
    val place: URI,
    val key: String,
)

/** Lets in whom the institution has signed in, by OpenID Connect or by the word of a trusted proxy. */
class InstitutionSignIn(
    private val settings: InstitutionSettings,
    private val database: Database,
    private val accounts: Accounts,
    clock: InstantSource,
) {
    private val provider = settings.provider?.let { OpenIdProvider(it, clock) }
    private val begun = OnceOnly(database, clock, "institution")
    private val choices = OnceOnly(database, clock, "institution-choice")

    /** The header by which a proxy names people; null where the provider is asked. */
    val header: String? get() = settings.header

    /** Begins to ask the provider; [page] is wanted after that. */
    suspend fun begin(page: String): Errand =
        withContext(ELSEWHERE) {
            val sent = Begun.of(page)
            Errand(asked().entry(sent), begun.keep(Json.encodeToString(sent)))
        }

    /**
     * Ends what this browser began.
     *
     * @param key that the browser kept
     * @throws SignInRefused
     */
    suspend fun finish(
        key: String?,
        answer: Map<String, List<String>>,
    ): Entrances =
        withContext(ELSEWHERE) {
            val kept = key?.let(begun::take) ?: throw SignInRefused(SignInFault.STALE)
            val sent = Json.decodeFromString<Begun>(kept)
            Entrances(entrances(asked().name(sent, answer)), sent.page)
        }

    /** Tells what [name] may enter, a name that a trusted proxy has told. */
    fun named(
        name: String?,
        page: String,
    ): Entrances = Entrances(entrances(name ?: throw SignInRefused(SignInFault.NO_PROXY)), page)

    /** Keeps what a person may choose among, under the key that it returns. */
    fun keep(entrances: Entrances): String =
        choices.keep(
            Json.encodeToString(KeptEntrances(entrances.all.map { it.who.id to it.course }, entrances.page)),
        )

    /** Gives out, once, what the browser with this key may choose among. */
    fun choices(key: String?): Entrances {
        val text = key?.let(choices::take) ?: throw SignInRefused(SignInFault.STALE)
        val kept = Json.decodeFromString<KeptEntrances>(text)
        val all = kept.accounts.mapNotNull { (id, course) -> accounts.withId(id)?.let { Entrance(it, course) } }
        return Entrances(all, kept.page)
    }

    /** Where people sign out of their institution too; null where it has not told. */
    fun exit(): URI? = provider?.exit()

    private fun asked() = provider ?: throw SignInRefused(SignInFault.NO_PROXY)

    private fun entrances(name: String): List<Entrance> {
        val staff = settings.staff[key(name)]?.let(accounts::withId)
        val found =
            listOfNotNull(staff?.takeIf { it is Identity.StaffIdentity }?.let { Entrance(it, course = "") }) +
                students(name).mapNotNull { (id, course) -> accounts.withId(id)?.let { Entrance(it, course) } }
        return found.ifEmpty { throw SignInRefused(SignInFault.UNKNOWN, name) }
    }

    /** The ids of the students whom rosters call so, with the names of their courses. */
    private fun students(name: String): List<Pair<String, String>> =
        database
            .read { handle ->
                handle
                    .createQuery(
                        """SELECT student_id, value, courses.name AS course FROM roster_fields
                           JOIN students ON students.id = student_id JOIN courses ON courses.id = course_id
                           WHERE kind = :kind AND (value = :name OR lower(value) = :key)
                           ORDER BY courses.created_at, courses.id""",
                    ).bind("kind", settings.column)
                    .bind("name", name)
                    .bind("key", key(name))
                    .map { row, _ ->
                        Triple(row.getString("student_id"), row.getString("value"), row.getString("course"))
                    }.list()
            }.filter { key(it.second) == key(name) }
            .map { it.first to it.third }

    /** The form that two names are compared in. Of addresses, the size of Latin letters does not count; other letters do. */
    private fun key(name: String) = key(settings.column, name)

    companion object {
        /** Waits for the provider, on threads of its own: one that hangs holds up nobody else's request. */
        private val ELSEWHERE = Dispatchers.IO.limitedParallelism(16)

        /** How long people have to sign in at their institution. */
        val PATIENCE = OnceOnly.LIFE

        /** The columns of a roster that name a student. */
        val COLUMNS: List<String> =
            RosterColumn.entries.filter { it.names && it != RosterColumn.CANVAS_ID }.map { it.kind }

        /** The form that [name] is compared in, where it stands in the column of a roster. */
        fun key(
            column: String,
            name: String,
        ): String =
            if (column != RosterColumn.EMAIL.kind) {
                name
            } else {
                String(CharArray(name.length) { if (name[it] in 'A'..'Z') name[it] + ('a' - 'A') else name[it] })
            }
    }
}
