// Learning platforms that send people here by LTI 1.3, and take their scores. Start with Launches, then see ScoreSender.
package rasterlab.grader.lti

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Name
import rasterlab.grader.institution.ProviderSettings
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.net.URI
import java.net.URISyntaxException
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource

/**
 * A place of a learning platform in which this server is registered.
 *
 * @param issuer what the platform calls itself
 * @param clientId what it calls this server
 * @param deployment what it calls this place of it; another one is another registration
 * @param login where people are signed in there
 * @param token where this server asks for leave to send scores
 * @param keys where its public keys are
 * @param makesStaff whether whoever teaches there becomes staff here unasked
 */
data class Platform(
    val id: String,
    val name: String,
    val issuer: String,
    val clientId: String,
    val deployment: String,
    val login: URI,
    val token: URI,
    val keys: URI,
    val makesStaff: Boolean,
    val addedAt: Instant,
)

/** A registration as somebody wrote it; the words are those of [Platform]. */
class PlatformForm(
    val name: String,
    val issuer: String,
    val clientId: String,
    val deployment: String,
    val login: String,
    val token: String,
    val keys: String,
    val makesStaff: Boolean,
)

/** The platforms that this installation trusts. */
class Platforms(
    private val database: Database,
    private val clock: InstantSource,
) {
    fun all(): List<Platform> = database.read { select(it, "") }

    fun find(id: String): Platform? = database.read { select(it, "WHERE id = :id", "id" to id).singleOrNull() }

    /** Finds those that call themselves and this server so. */
    fun of(
        issuer: String,
        clientId: String,
    ): List<Platform> =
        database.read {
            select(it, "WHERE issuer = :issuer AND client_id = :client", "issuer" to issuer, "client" to clientId)
        }

    /**
     * Finds those that may begin a launch with these words.
     *
     * @param clientId null where the platform does not tell
     * @param deployment null where the platform does not tell
     */
    fun named(
        issuer: String,
        clientId: String?,
        deployment: String?,
    ): List<Platform> =
        database
            .read { select(it, "WHERE issuer = :issuer", "issuer" to issuer) }
            .filter { clientId == null || it.clientId == clientId }
            .filter { deployment == null || it.deployment == deployment }

    /**
     * Registers one.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it registers nothing twice
     * @throws Rejection.BadPlatform
     */
    fun add(
        form: PlatformForm,
        by: String,
        key: String?,
    ): Platform {
        val made =
            Platform(
                Secrets.newId(),
                Name.of(form.name).text,
                word("issuer", form.issuer),
                word("client-id", form.clientId),
                word("deployment", form.deployment),
                address("login-url", form.login),
                address("token-url", form.token),
                address("keys-url", form.keys),
                form.makesStaff,
                clock.instant(),
            )
        val request = Repeatable("platforms $by", key, made.copy(id = "", addedAt = Instant.EPOCH).toString())
        return database.write { handle ->
            request.made(handle)?.let { id ->
                return@write select(handle, "WHERE id = :id", "id" to id).singleOrNull()
                    ?: throw Rejection.UnknownPlatform(id)
            }
            if (insert(handle, made) == 0) {
                throw Rejection.BadPlatform("taken", made.issuer, made.clientId, made.deployment)
            }
            val detail = "${made.issuer} ${made.clientId} ${made.deployment}" + if (made.makesStaff) " staff" else ""
            AuditNote(by, course = null, "lti-add", made.id, detail).write(handle, made.addedAt)
            request.remember(handle, made.id, made.addedAt)
            made
        }
    }

    /**
     * Ends a registration: who came by it and what is still to be sent there is forgotten; students and their work stay.
     *
     * @param by who does it, for the audit
     * @throws Rejection.UnknownPlatform
     */
    fun remove(
        id: String,
        by: String,
    ): Platform =
        database.write { handle ->
            val found =
                select(handle, "WHERE id = :id", "id" to id).singleOrNull() ?: throw Rejection.UnknownPlatform(id)
            handle
                .createUpdate(
                    """DELETE FROM lti_scores WHERE link_id IN (SELECT id FROM lti_links WHERE platform_id = :id)""",
                ).bind("id", id)
                .execute()
            for (table in OF_A_PLATFORM) {
                handle.createUpdate("DELETE FROM $table WHERE platform_id = :id").bind("id", id).execute()
            }
            handle.createUpdate("DELETE FROM lti_platforms WHERE id = :id").bind("id", id).execute()
            AuditNote(by, course = null, "lti-remove", id, "${found.issuer} ${found.clientId} ${found.deployment}")
                .write(handle, clock.instant())
            found
        }

    private fun insert(
        handle: Handle,
        made: Platform,
    ): Int =
        handle
            .createUpdate(
                """INSERT INTO lti_platforms (id, name, issuer, client_id, deployment, login_url, token_url, keys_url,
                       makes_staff, added_at)
                   VALUES (:id, :name, :issuer, :client, :deployment, :login, :token, :keys, :staff, :now)
                   ON CONFLICT (issuer, client_id, deployment) DO NOTHING""",
            ).bind("id", made.id)
            .bind("name", made.name)
            .bind("issuer", made.issuer)
            .bind("client", made.clientId)
            .bind("deployment", made.deployment)
            .bind("login", "${made.login}")
            .bind("token", "${made.token}")
            .bind("keys", "${made.keys}")
            .bind("staff", if (made.makesStaff) 1 else 0)
            .bind("now", made.addedAt.text())
            .execute()

    private fun select(
        handle: Handle,
        condition: String,
        vararg values: Pair<String, String>,
    ): List<Platform> =
        handle
            .createQuery("SELECT * FROM lti_platforms $condition ORDER BY added_at, id")
            .bindMap(values.toMap())
            .map { row, _ -> platform(row) }
            .list()

    private fun platform(row: ResultSet) =
        Platform(
            row.getString("id"),
            row.getString("name"),
            row.getString("issuer"),
            row.getString("client_id"),
            row.getString("deployment"),
            URI(row.getString("login_url")),
            URI(row.getString("token_url")),
            URI(row.getString("keys_url")),
            row.getInt("makes_staff") == 1,
            Instant.parse(row.getString("added_at")),
        )

    companion object {
        /** The most characters of an id in LTI 1.3. */
        const val LONGEST = 255

        private val OF_A_PLATFORM = listOf("lti_links", "lti_students", "lti_staff", "lti_contexts")

        private fun word(
            field: String,
            text: String,
        ): String =
            text.trim().takeIf { it.length in 1..LONGEST && it.all { sign -> sign in '!'..'~' } }
                ?: throw Rejection.BadPlatform("word", field, text.trim().length, LONGEST)

        private fun address(
            field: String,
            text: String,
        ): URI {
            val address =
                try {
                    URI(text.trim())
                } catch (failure: URISyntaxException) {
                    throw Rejection.BadPlatform("address", field, text.trim())
                }
            if (!ProviderSettings.isPrivate(address) || address.fragment != null || address.userInfo != null) {
                throw Rejection.BadPlatform("address", field, text.trim())
            }
            return address
        }
    }
}
